load "style.gp"
set output ARG2
set xlabel "x across the rail, in"
set ylabel "height, in"
set autoscale xfix
set yrange [-0.35:0.18]
set key top right
set arrow from 0, graph 0 to 0, graph 1 nohead ls guide front
set label "wheel: tread 12.34 in, rolling radius 18 in" at -1.4,0.1 front
set label "O" at 0.02,0.02 front
set style fill solid 0.25
set label "rail: crown 10 in" at -1.4,-0.2 front
plot ARG1 using "x_in":"wheel_in":(0.3) with filledcurves lc rgb sky, \
     "" using "x_in":"rail_in":(-0.4) with filledcurves lc rgb grey, \
     "" using "x_in":"wheel_in" with lines lt 2 title "tread of the wheel, concave", \
     "" using "x_in":"rail_in" with lines lt 1 title "head of the rail"
