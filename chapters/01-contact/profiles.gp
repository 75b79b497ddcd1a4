# alt: Section across the rail. The hollow tread of the wheel lies on the head of the rail and touches it at O; the gap opens to both sides, faster where the rail's radius is smaller.
load "style.gp"
set terminal pngcairo size 740,330 font "DejaVu Sans,12" enhanced background rgb "white"
set output ARG2
set xlabel "x across the rail, in"
set ylabel "height, in"
set autoscale xfix
unset key
set yrange [-0.35:0.18]
set arrow from 0, graph 0 to 0, graph 1 nohead ls guide front
set label "O" at 0.02,0.02 front
set style fill solid 0.25
plot ARG1 using "x_in":"wheel_in":(0.3) with filledcurves lc rgb sky, \
     "" using "x_in":"rail_in":(-0.4) with filledcurves lc rgb grey, \
     "" using "x_in":"wheel_in" with lines lt 2 title "tread of the wheel", \
     "" using "x_in":"rail_in" with lines lt 1 title "head of the rail", \
     ARG3 using "x_in":"z_in":"label" with labels left notitle
