# alt: Profile along the axis of the roller, flat in the middle half and bending down by up to a thousandth of an inch at the ends; a dashed copy raised by the approach overlaps the straight body above.
load "style.gp"
set terminal pngcairo size 740,330 font "DejaVu Sans,12" enhanced background rgb "white"
set output ARG2
unset key
set xlabel "x along the axis, in"
set ylabel "height, 10^{-3} in"
set xrange [-0.9:0.9]
set yrange [-1.8:1.4]
set arrow 1 from 0, 0 to 0, 0.65 heads size 0.012,20 filled lw 1.6 lc rgb blue front
set label 1 "approach δ" at 0.03, 0.3 tc rgb blue front
set label 2 "cylinder, 1 in radius" at 0, 1.15 center front
set label 3 "crowned cylinder, 1 in radius, straight for |x| < 0.5 in,\ncrown radius 85 in beyond" at 0, -0.5 center front
set label 4 "dashed: moved by the approach, undeformed" at 0, -1.4 center front tc rgb blue
plot ARG1 using "x_in":(0):(1.6) with filledcurves lc rgb light, \
     ARG1 using "x_in":(-column("crowned_mil")):(-2.2) with filledcurves lc rgb "#BFD9EA", \
     ARG1 using "x_in":(0) with lines lt 8 notitle, \
     ARG1 using "x_in":(-column("crowned_mil")) with lines lt 1, \
     ARG1 using "x_in":(0.65 - column("crowned_mil")) with lines lt 2
