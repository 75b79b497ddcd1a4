load "style.gp"
set output ARG2
set xlabel "x along the axis, in"
set ylabel "height, 10^{-3} in"
set xrange [-0.9:0.9]
set yrange [-2.2:1.6]
set key bottom center
set arrow 1 from 0, 0 to 0, 0.65 nohead lw 2 lc rgb blue
set label 1 "approach 0.65" at 0.02, 0.3 tc rgb blue front
set label 2 "body 2: cylinder, 1 in radius" at 0, 1.15 center front
set label 3 "body 1: cylinder, 1 in radius, straight for |x| < 0.5 in,\ncrown radius 85 in beyond" at 0, -0.4 center front
plot ARG1 using "x_in":(0):(1.6) with filledcurves lc rgb light title "the straight body", \
     ARG1 using "x_in":(-column("crowned_mil")):(-2.2) with filledcurves lc rgb "#BFD9EA" title "the crowned body", \
     ARG1 using "x_in":(0) with lines lt 8 notitle, \
     ARG1 using "x_in":(-column("crowned_mil")) with lines lt 1 title "its generator", \
     ARG1 using "x_in":(0.65 - column("crowned_mil")) with lines lt 2 title "the same moved by the approach, undeformed"
