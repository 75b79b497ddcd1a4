# alt: Left, nanoseconds a sample against the length of the record for four methods; weights take most, sums and stream least. Right, their errors, all between 1e-16 and 1e-12 of the RMS.
load "style.gp"
set terminal pngcairo size 740,400 font "DejaVu Sans,11"
set output ARG2
stats ARG1 using "ns" nooutput
timed = STATS_max > 0
stats ARG1 using "samples" name "n" nooutput
names = "weights transforms sums stream"
set logscale xy
set format x "10^{%T}"
set xlabel "samples of the record"
set xrange [100:*]
set multiplot layout 1,2
unset key
set lmargin 11
set rmargin 1.5
set ylabel timed ? "time a sample, ns" : "operations a sample"
set yrange [1:*]
of(m) = strcol("method") eq m
cost(q) = timed ? column(q."ns") : column("operations")
plot for [i=1:4] ARG1 using (of(word(names,i)) && timed ? column("samples") : NaN):(cost("")):(cost("q1_")):(cost("q3_")) \
         with yerrorbars lt i pt -1 dt 1, \
     for [i=1:4] ARG1 using (of(word(names,i)) ? column("samples") : NaN):(cost("")) with linespoints lt i, \
     for [i=1:4] ARG1 using (of(word(names,i)) && column("samples") == 1000 ? 1000 : NaN):(cost("")):"method" with labels right offset -1,0 tc lt i
set format y "10^{%T}"
set ylabel "largest error over the RMS"
set yrange [1e-17:1e-11]
set rmargin 11
set xrange [500:*]
plot for [i=1:4] ARG1 using (of(word(names,i)) ? column("samples") : NaN):"error" with linespoints lt i, \
     for [i=1:4] ARG1 using (of(word(names,i)) && column("samples") == n_max ? n_max : NaN):"error":"method" with labels left offset 1.4,0 tc lt i
unset multiplot
