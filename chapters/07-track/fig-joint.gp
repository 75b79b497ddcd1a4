load "style.gp"
set output ARG2
set style textbox opaque noborder margins 0.3,0.3
set xlabel "time after the joint, ms"
set ylabel "wheel/rail force, kN"
set xrange [-4:20]
set yrange [60:220]
set arrow from -4,122.33 to 20,122.33 nohead ls guide
plot ARG4 using 1:2 with lines lt 7 title "upper layer with ζ = 0.3", \
     ARG1 using 1:3 with lines lt 3 title "running mean, one period of the middle mode", \
     ARG1 using 1:2 with lines lt 1 title "ζ = 0.05", \
     ARG3 using 1:2 with points ls other, \
     ARG3 using 1:2:3 with labels boxed offset 0,1 tc rgb green font ",13"
