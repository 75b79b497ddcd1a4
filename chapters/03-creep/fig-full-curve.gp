# alt: Left: the fraction of the friction limit rises with X, straight at first and then levelling off at one near 0.5; the independent program's points lie on the curve, Vermeulen and Johnson's curve runs above it and FASTSIM's below. Right: mean errors on double logarithmic axes; the error with filled rows falls with slope minus one, that with placed ends is ten times smaller and falls faster.
load "style.gp"
set output ARG2
set terminal pngcairo size 1100,360 font "DejaVu Sans,13" enhanced background rgb "white"
set multiplot layout 1,2
unset key
set rmargin 2
set xlabel "X = G a b ξ / (µ_c N)"
set ylabel "f = µ / µ_c"
set xrange [0:0.8]
set yrange [0:1.05]
set label 1 "full theory" at 0.42,0.87 left
set arrow 1 from 0.41,0.88 to 0.335,0.915 nohead lw 1
set label 2 "○ independent program" at 0.42,0.77 left tc rgb "#007A5A"
set label 3 "Vermeulen-\nJohnson" at 0.015,0.97 left tc rgb "#606060"
set arrow 3 from 0.13,0.88 to 0.19,0.745 nohead lw 1 lc rgb "#606060"
set label 4 "FASTSIM" at 0.30,0.66 left tc rgb "#3A799C"
set arrow 4 from 0.295,0.67 to 0.235,0.745 nohead lw 1 lc rgb "#3A799C"
plot ARG3 using "X":"vermeulen_johnson" with lines lt 8 lw 2, \
     ARG3 using "X":"fastsim" with lines lt 7 lw 2, \
     ARG1 using "X":"f" smooth unique with lines lt 1, \
     ARG4 using "X":"f" with points ls other pt 6
unset for [i=1:4] label i
unset for [i=1:4] arrow i
set xlabel "cells along rolling (half as many rows)"
set ylabel "mean error of f at six creeps"
set logscale xy
set xrange [3.5:28]
set yrange [1e-4:0.1]
set format y "10^{%T}"
set xtics (4,6,8,12,16,24)
set label 1 "cells just fill the rows" at 9,0.028 left tc rgb blue
set label 2 "ends of the rows placed" at 7.3,0.0022 left tc rgb "#BE5400"
set label 3 "slope −1" at 13.5,0.0078 left tc rgb "#606060"
set label 4 "slope −2" at 5.6,0.00035 right tc rgb "#606060"
plot ARG5 using "cells":"filled" with linespoints lt 2, \
     ARG5 using "cells":"placed" with linespoints lt 3, \
     0.075/x with lines ls guide, 0.028/x**2 with lines ls guide
unset multiplot
