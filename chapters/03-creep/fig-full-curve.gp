load "style.gp"
set output ARG2
set terminal pngcairo size 1300,600
set multiplot layout 1,2
set xlabel "X = G a b ξ / μN"
set ylabel "f = F / μN"
set xrange [0:0.8]
set yrange [0:1.05]
set key bottom right
plot ARG1 using "X":"f" with lines lt 1 title "full theory, this chapter", \
     ARG3 using "X":"f" with points ls other title "independent program"
set xlabel "cells along rolling (half as many rows)"
set ylabel "mean error of f over the curve"
set logscale xy
set xrange [3.5:40]
set yrange [5e-5:1]
set format y "10^{%T}"
set xtics (4,6,8,12,16,24,32)
set key top right
plot ARG4 using "cells":"filled" with linespoints lt 2 title "cells fill the rows", \
     ARG4 using "cells":"placed" with linespoints lt 3 title "ends placed", \
     0.3/x with lines ls guide title "slopes -1 and -2", 0.08/x**2 with lines ls guide
unset multiplot
