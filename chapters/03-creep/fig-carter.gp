load "style.gp"
set output ARG2
set terminal pngcairo size 1300,560
set multiplot layout 1,2
set xlabel "x/a, rolling to the right"
set ylabel "traction / μp_0"
set xrange [-1.05:1.05]
set yrange [0:1.32]
set key top center horizontal maxrows 2
plot ARG1 using "s":"bound" with lines ls guide title "bound", \
     ARG1 using "s":"high" with lines lt 3 title "Q = 0.9 μP", \
     ARG1 using "s":"middle" with lines lt 1 title "0.64", \
     ARG1 using "s":"low" with lines lt 2 title "0.2"
set xlabel "cells"
set ylabel "|error of Q/μP|, Q = 0.64 μP"
set logscale xy
set xrange [5:500]
set yrange [1e-7:10]
set format y "10^{%T}"
set key top right maxrows 4
plot ARG3 using "cells":"filled" with linespoints lt 2 title "cells fill the width", \
     ARG3 using "cells":"placed" with linespoints lt 3 title "ends placed", \
     0.15/x with lines ls guide title "slopes -1 and -2", 0.2/x**2 with lines ls guide
unset multiplot
