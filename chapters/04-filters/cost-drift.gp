# alt: Largest error over the RMS against samples since the start, on logarithmic axes. Integrators rise steeply, in single precision at once and in double precision later; sums in single precision rise slowly, in double precision they stay at rounding.
load "style.gp"
set terminal pngcairo size 740,400 font "DejaVu Sans,11"
set output ARG2
set logscale xy
set format "10^{%T}"
set xlabel "samples since the start"
set ylabel "largest error over the RMS"
set yrange [1e-17:*]
set autoscale xfixmax
set xrange [7e4:*]
set rmargin 26
set key outside right center nobox font ",10"
name(i) = word("sums integrators", 1 + i / 2) . " in " . word("single double", 1 + i % 2) . " precision"
plot for [i=0:3] ARG1 using (strcol("method") eq name(i) ? column("samples") : NaN):"error" with linespoints lt i + 1 title word("sums integrators", 1 + i / 2) . ", " . word("single double", 1 + i % 2)
