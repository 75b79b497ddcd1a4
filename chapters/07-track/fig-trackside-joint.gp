load "style.gp"
set output ARG2
set xlabel "wheel's distance past the point, m; joint at −0.5 m"
set ylabel "rail deflection at the point, mm (down)"
set yrange [*:*] reverse
set autoscale xfix
set xzeroaxis ls guide
set arrow from -0.5, graph 0 to -0.5, graph 1 nohead ls guide
set key bottom left
plot ARG1 using 1:2 with lines lt 2 title "constant load", \
     ARG1 using 1:3 with lines lt 1 title "forces over the joint"
