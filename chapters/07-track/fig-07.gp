# alt: Above, arches of the left and the right rail, shifted by half a rail. Below, what a car
# alt: feels: the mean of both, which has two dips in a rail length, and half their difference,
# alt: which has one wave.
load "style.gp"
set terminal pngcairo size 1000,560
set output ARG2
set multiplot layout 2,1
set xrange [0:117]
set xtics 19.5
set yrange [0.6:-0.3]
set ytics 0.2
set lmargin 9
set key horizontal top right
set ylabel "rail, in (down)"
plot ARG1 using "distance_ft":"left_in" with lines lt 1 title "left rail", \
     ARG1 using "distance_ft":"right_in" with lines lt 2 title "right rail"
set yrange [0.4:-0.6]
set xlabel "distance, ft"
set ylabel "car feels, in"
plot ARG1 using "distance_ft":"bounce_in" with lines lt 1 title "bounce", \
     ARG1 using "distance_ft":"roll_in" with lines lt 2 title "roll"
unset multiplot
