load "style.gp"
set output ARG2
set xlabel "time after the joint, ms"
set ylabel "wheel/rail force, kN"
set xrange [-1:10]
set yrange [0:600]
plot ARG1 using 1:2 with lines lt 2 title "dip of 1 in", \
     ARG1 using 1:3 with lines lt 1 title "dip of 1.5 in"
