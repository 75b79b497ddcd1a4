# ARG1: a describing function of the three wheels.
# alt: A gain against amplitude for three wheels: level up to 0.2 to 0.4 in, then rising steeply; the Heumann wheel first and highest.
load "style.gp"
set terminal pngcairo size 740,270 font "DejaVu Sans,12" enhanced background rgb "white"
set output ARG2
set xlabel "amplitude A of the wheelset, in"
set ylabel "gain, per x_w/a" offset 0.5
set xrange [0:0.75]
set yrange [0:*]
set key left top Left reverse nobox
set tmargin 1
set rmargin 2
zero(y) = y > 0 ? y : 0 # what is zero but for rounding
plot ARG1 using "A_in":"heumann" with lines lt 3 title "modified Heumann", \
     ARG1 using "A_in":"cn" with lines lt 2 title "CN A", \
     ARG1 using "A_in":(zero(column("new"))) with lines lt 1 title "new wheel"
