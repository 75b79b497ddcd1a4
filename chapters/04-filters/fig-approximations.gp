load "style.gp"
set output ARG2
set logscale xy
set xrange [0.5:120]
set yrange [1e-10:10]
set format y "10^{%T}"
set xlabel "speed, mph (corner 1 Hz, reconstructed)"
set ylabel "share of the past left in the output"
set xtics (0.5, 1, 2, 5, 10, 20, 50, 120)
set key bottom left
plot ARG1 using "speed_mph":"linear" with lines lt 1 title "1 − κ", \
     ARG1 using "speed_mph":"reciprocal" with lines lt 2 title "1/(1 + κ)", \
     ARG1 using "speed_mph":"pade11" with lines lt 3 title "Padé (1,1)", \
     ARG1 using "speed_mph":"pade22" with lines lt 4 title "Padé (2,2)"
