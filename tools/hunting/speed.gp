load "style.gp"
set terminal pngcairo size 1000,800 font "DejaVu Sans,14" enhanced background rgb "white"
set output ARG2
set multiplot layout 2,1
set lmargin 10
set autoscale xfix
set ylabel "growth rate, 1/s"
set arrow from graph 0,first 0 to graph 1,first 0 nohead ls guide
set key top left
plot ARG1 using 1:2 with lines lt 1 title "least damped mode", \
     ARG1 using 1:4 with lines lt 2 title "next"
unset arrow
unset key
set xlabel "speed, m/s"
set ylabel "frequency, rad/s"
set yrange [0:*]
plot ARG1 using 1:3 with lines lt 1, ARG1 using 1:5 with lines lt 2
unset multiplot
