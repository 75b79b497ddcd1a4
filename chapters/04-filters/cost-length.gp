load "style.gp"
set output ARG2
set terminal pngcairo size 1200,480
stats ARG1 using "ns" nooutput
timed = STATS_max > 0
names = "weights transforms sums stream"
set logscale xy
set format x "10^{%T}"
set xlabel "samples of the record"
set xrange [500:*]
set multiplot layout 1,2
set key outside top center horizontal nobox
set ylabel timed ? "ns a sample" : "operations a sample"
set yrange [1:*]
of(m) = strcol("method") eq m
cost(q) = timed ? column(q."ns") : column("operations")
plot for [i=1:4] ARG1 using (of(word(names,i)) ? column("samples") : NaN):(cost("")) with linespoints lt i title word(names,i), \
     for [i=1:4] ARG1 using (of(word(names,i)) && timed ? column("samples") : NaN):(cost("")):(cost("q1_")):(cost("q3_")) \
         with yerrorbars lt i ps 0 notitle
set format y "10^{%T}"
set ylabel "largest error over the RMS"
set yrange [1e-17:1e-11]
plot for [i=1:4] ARG1 using (of(word(names,i)) ? column("samples") : NaN):"error" with linespoints lt i title word(names,i)
unset multiplot
