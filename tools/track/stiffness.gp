load "style.gp"
set output ARG2
set xlabel "distance along the rail, m"
set ylabel "deflection, mm (down)"
set yrange [*:*] reverse
set xzeroaxis ls guide
plot ARG1 using "distance_m":"deflection_mm" with lines lt 1 title "rail"
