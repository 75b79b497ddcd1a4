load "style.gp"
set output ARG2
set logscale xy
set format "10^{%T}"
set xlabel "samples since the start"
set ylabel "largest error over the RMS"
set yrange [1e-17:*]
set key at graph 0.62, 0.5
set xrange [7e4:*]
name(i) = word("sums integrators", 1 + i / 2) . " in " . word("single double", 1 + i % 2) . " precision"
plot for [i=0:3] ARG1 using (strcol("method") eq name(i) ? column("samples") : NaN):"error" with linespoints lt i + 1 title name(i)
