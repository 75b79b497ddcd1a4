load "style.gp"
set terminal pngcairo size 1000,850
set output ARG2
stats ARG5 using "threshold" nooutput
T = STATS_max
stats ARG5 using "places" nooutput
places = STATS_max
set multiplot layout 2,1
set lmargin 10
set key above horizontal maxrows 1
set autoscale xfix
set xlabel "distance, km"
set ylabel "descriptor"
set arrow 1 from graph 0,first T to graph 1,first T nohead ls guide front
set arrow 2 from graph 0,first -T to graph 1,first -T nohead ls guide front
if (places > 0) {
  plot ARG1 using "distance_km":"low":"high" with filledcurves lc rgb blue title "descriptor", \
       ARG3 using (column("distance_m")/1000):"descriptor" with points lc rgb red pt 6 ps 1.2 title sprintf("beyond %g", T)
} else {
  plot ARG1 using "distance_km":"low":"high" with filledcurves lc rgb blue title sprintf("descriptor, never beyond %g", T)
}
unset arrow 2
set arrow 1 from T,graph 0 to T,graph 1 nohead ls guide front
set logscale y
set format y "10^{%L}"
set yrange [0.5:*]
set xrange [0:4]
set boxwidth 0.018
set xlabel "magnitude of the descriptor"
set ylabel "samples"
unset key
plot ARG4 using "descriptor":"samples" with boxes lc rgb blue
unset multiplot
