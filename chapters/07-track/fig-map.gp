load "style.gp"
set output ARG2
set logscale xy
set xlabel "joint angle × speed, m/s"
set ylabel "force above the static load, kN"
set xrange [0.03:1]
set key top left
plot ARG1 using 1:3 with lines lt 1 title "largest before 2.5 ms", \
     ARG1 using 1:2 with lines lt 2 title "P1", \
     ARG1 using 1:4 with lines lt 3 title "P2, running mean"
