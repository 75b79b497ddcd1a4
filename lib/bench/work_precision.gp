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
set terminal pngcairo size (timed > 0 ? 1400 : 950),560
stats ARG1 using "error" nooutput
set yrange [0.3 * (floor > 1e-3 * STATS_min && floor < STATS_min ? floor : STATS_min):3 * STATS_max]
if (floor > 1e-3 * STATS_min) {
  set object 1 rectangle from graph 0, graph 0 to graph 1, first floor fc rgb light fs solid noborder behind
}

# The panels leave a margin on the right for the key; the reference's own uncertainty is named below it.
right = timed > 0 ? 0.78 : 0.66
set multiplot
set bmargin screen 0.15
set tmargin screen 0.94
unset key
if (timed > 0) {
  set lmargin screen 0.08
  set rmargin screen 0.40
  set xlabel "run time, s"
  plot for [i = 1:n] ARG1 using (strcol("method") eq method[i] ? column("seconds_min_s") : NaN):"error" \
       with linespoints lt i notitle
}
set lmargin screen timed > 0 ? 0.49 : 0.13
set rmargin screen right - 0.01
set xlabel "work count"
set key at screen right + 0.01, screen 0.94 left top vertical Left reverse nobox font ",12" samplen 3
if (floor > 0) {
  set label 1 sprintf("reference known to %.0e", floor) at screen right + 0.02, screen 0.17 font ",11" textcolor rgb grey
}
plot for [i = 1:n] ARG1 using (strcol("method") eq method[i] ? column("work") : NaN):"error" \
     with linespoints lt i title method[i]
unset multiplot
