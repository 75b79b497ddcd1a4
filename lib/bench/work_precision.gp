# Error against run time and against work, one line a method. ARG1: the CSV of bench::show, ARG2: the PNG.
load "style.gp"
set output ARG2

# The methods in order of appearance, whether time was measured at all, and what the reference itself does not know.
array method[32]
n = 0
timed = 0
floor = 0
previous = ""
note(name, seconds, uncertainty) = (name ne previous ? (n = n + 1, method[n] = name) : 0, \
  previous = name, timed = timed + (seconds > 0), floor = uncertainty, 1)
set yrange [0:2]
set table $unused
plot ARG1 using (note(strcol("method"), column("seconds_min_s"), column("reference_uncertainty")))
unset table
set autoscale y

set logscale xy
set format "10^{%T}"
set ylabel "relative error"
set key at graph 0.5, screen 0.99 center top horizontal maxrows 2 nobox font ",12"
set tmargin 5
set terminal pngcairo size (timed > 0 ? 1300 : 800),620
set multiplot layout 1,(timed > 0 ? 2 : 1)
stats ARG1 using "error" nooutput
set yrange [0.3 * (floor > 0 && floor < STATS_min ? floor : STATS_min):3 * STATS_max]
if (floor > 0) { set object 1 rectangle from graph 0, graph 0 to graph 1, first floor fc rgb light fs solid noborder behind }
if (timed > 0) {
  set xlabel "run time, s"
  plot for [i = 1:n] ARG1 using (strcol("method") eq method[i] ? column("seconds_min_s") : NaN):"error" \
       with linespoints lt i title method[i]
  unset key
}
set xlabel "work count"
plot for [i = 1:n] ARG1 using (strcol("method") eq method[i] ? column("work") : NaN):"error" \
     with linespoints lt i title method[i]
unset multiplot
