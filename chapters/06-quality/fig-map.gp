load "style.gp"
set output ARG2
unset key
set xrange [0:2000]
set yrange [30:180]
set xlabel "distance, m (synthetic track)"
set ylabel "posted speed, km/h"
set cblabel "largest |descriptor|; limit 1"
set cbrange [0:1.5]
set grid noxtics noytics
set rmargin 12
plot ARG1 using "distance_m":"speed_kmh":"descriptor" with image
