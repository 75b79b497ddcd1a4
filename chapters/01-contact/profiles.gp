load "style.gp"
set output ARG2
set xlabel "x across the rail, in"
set ylabel "height, in"
set autoscale xfix
set yrange [-0.35:0.18]
set key bottom left
set arrow from 0, graph 0 to 0, graph 1 nohead ls guide front
set label "O" at 0.02,0.02 front
set style fill solid 0.25
plot ARG1 using "x_in":"wheel_in":(0.3) with filledcurves lc rgb sky, \
     "" using "x_in":"rail_in":(-0.4) with filledcurves lc rgb grey, \
     "" using "x_in":"wheel_in" with lines lt 2 title "tread of the wheel, concave", \
     "" using "x_in":"rail_in" with lines lt 1 title "head of the rail", \
     ARG3 using "x_in":"z_in":"label" with labels left notitle
