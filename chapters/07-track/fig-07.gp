# alt: Above, arches of the left and the right rail, shifted by half a rail. Below, what a car
# alt: feels: the mean of both, which has two dips in a rail length, and half their difference,
# alt: which has one wave.
load "style.gp"
set terminal pngcairo size 1000,520
set output ARG2
set multiplot layout 2,1
unset key
set xrange [0:117]
set xtics 19.5
set ytics 0.2
set lmargin 9
set yrange [0.55:-0.12]
set ylabel "sag, in"
set label 1 "left rail" at 58.5,-0.05 center
set label 2 "right rail" at 78,-0.05 center tc rgb blue
plot ARG1 using "distance_ft":"left_in" with lines lt 1, \
     ARG1 using "distance_ft":"right_in" with lines lt 2
set yrange [0.32:-0.37]
set xlabel "distance, ft"
set ylabel "bounce and roll, in"
set label 1 "bounce" at 58.5,0.12
set label 2 "roll" at 58.5,-0.3
plot ARG1 using "distance_ft":"bounce_in" with lines lt 1, \
     ARG1 using "distance_ft":"roll_in" with lines lt 2
unset multiplot
