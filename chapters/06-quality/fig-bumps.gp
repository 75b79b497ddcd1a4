load "style.gp"
set output ARG2
set logscale x
set xrange [3:200]
set yrange [0:1.1]
set xtics (3,5,10,20,50,100,200)
set key top right
set xlabel "length of the versine bump, 1.6 cm high, m"
set ylabel "share of the limit"
plot ARG1 using "length_m":"descriptor" with linespoints lt 2 title "descriptor, peak", \
     ARG1 using "length_m":"stroke" with linespoints lt 1 title "stroke, worst speed 5 to 100 km/h"
