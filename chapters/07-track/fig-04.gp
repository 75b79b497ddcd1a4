load "style.gp"
set terminal pngcairo size 1000,600
set output ARG2
unset border
unset tics
unset grid
unset key
set xrange [-1.8:4.8]
set yrange [0.3:6.2]
set size ratio -1
set margins 0,0,0,0
set arrow from 0,5.75 to 0,5.5 lc rgb red lw 3 front
set arrow from 4.3,3.1 to 1.6,3.1 lw 2 lc rgb blue
set label "track, relative to the wheel, at V" at 2.95,3.25 center tc rgb blue
plot ARG1 using 1:2 with lines lt 1 lw 2, \
     ARG3 using 1:2:3 with labels font "DejaVu Sans,15"
