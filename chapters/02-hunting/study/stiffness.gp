# Cost at a fixed error against what makes the car stiff: method, stiffness, tolerance, error, seconds, steps, crossover. ARG1: speed, ARG3: sticking.
load "style.gp"
set output ARG2
set terminal pngcairo size 1400,560
timed = 0
set yrange [0:2]
set table $unused
plot ARG1 using (timed = timed + ($5 > 0), 1)
unset table
set autoscale y
cost = timed > 0 ? 5 : 6
array method[3] = ["explicit", "implicit", "exact pieces"]
set logscale xy
set format "10^{%T}"
set multiplot layout 1,2
set ylabel timed > 0 ? "run time, s" : "steps"
set yrange [timed > 0 ? 1e-5 : 5:timed > 0 ? 10 : 1e6]
set xlabel "speed V, ft/s"
set xrange [*<0.7:150]
set key top right
plot for [i = 1:3] ARG1 using (strcol("method") eq method[i] ? $2 : NaN):cost with linespoints lt i title method[i], \
     ARG1 using 7:cost with impulses ls guide title "crossover"
set xlabel "sticking rate, m/s"
set xrange [*<5e-6:2e-2]
plot for [i = 1:3] ARG3 using (strcol("method") eq method[i] ? $2 : NaN):cost with linespoints lt i title method[i], \
     ARG3 using 7:cost with impulses ls guide title "crossover"
unset multiplot
