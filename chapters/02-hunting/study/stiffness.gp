# Cost at a fixed error against what makes the car stiff: method, stiffness, tolerance, error, seconds, steps, crossover. ARG1: speed, ARG3: sticking.
# alt: Run time against speed and against sticking rate on logarithmic axes: the implicit method is level, the explicit one and exact
# alt: pieces rise steeply where the car is stiff.
load "style.gp"
set minussign
set output ARG2
set terminal pngcairo size 740,330 font "DejaVu Sans,12" enhanced background rgb "white"
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
set multiplot
set tmargin at screen 0.96
set bmargin at screen 0.2
set lmargin at screen 0.115
set rmargin at screen 0.49
set ylabel timed > 0 ? "run time, s" : "steps"
set yrange [timed > 0 ? 1e-5 : 5:timed > 0 ? 1 : 1e6]
set xlabel "speed V, ft/s"
set xrange [*<0.7:110]
unset key
plot for [i = 1:3] ARG1 using (strcol("method") eq method[i] ? $2 : NaN):cost with linespoints lt i, \
     ARG1 using 7:cost with impulses ls guide
set lmargin at screen 0.58
set rmargin at screen 0.97
unset ylabel
set key left bottom Left reverse nobox noopaque samplen 2 font ",11"
set xlabel "sticking rate, m/s"
set xrange [*<8e-6:1.1e-2]
plot for [i = 1:3] ARG3 using (strcol("method") eq method[i] ? $2 : NaN):cost with linespoints lt i title method[i], \
     ARG3 using 7:cost with impulses ls guide title "crossover"
unset multiplot
