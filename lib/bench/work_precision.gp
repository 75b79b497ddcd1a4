# Error against run time, one line a method. ARG1: the CSV of bench::show, ARG2: the PNG, ARG3: the frame (axes, the
# reference's uncertainty, expected slopes). Without times the work count is across.
load "style.gp"
set output ARG2

# The methods in order of appearance, and whether time was measured at all.
array method[32]
array runs[32] # of each, those that did not fail
do for [i = 1:32] { runs[i] = 0 }
n = 0
timed = 0
failures = 0
previous = ""
note(name, seconds, state) = (name ne previous ? (n = n + 1, method[n] = name) : 0, previous = name, \
  runs[n] = runs[n] + (state ne "failed"), timed = timed + (seconds > 0), failures = failures + (state eq "failed"), 1)
# The frame: ranges of the axes (0: from the data), the reference's uncertainty and 100 times that.
array range[6]
do for [i = 1:6] { range[i] = 0 }
slopes = 0
keep(what, a, b) = (what eq "error" ? (range[1] = a, range[2] = b) : \
                    what eq "seconds" ? (range[3] = a, range[4] = b) : \
                    what eq "reference" ? (range[5] = a, range[6] = b) : (slopes = slopes + 1), 1)
set yrange [0:2]
set table $unused
plot ARG1 using (note(strcol("method"), column("seconds_median_s"), strcol("state")))
plot ARG3 using (keep(strcol("what"), column("x1"), column("y1")))
unset table
set autoscale y

across(q) = timed > 0 ? column("seconds_" . q . "_s") : column("work")
set terminal pngcairo size 1100,600
set logscale xy
set format "10^{%T}"
set ylabel "relative error"
set xlabel timed > 0 ? "run time, s" : "work count"
stats ARG1 using (strcol("state") eq "failed" ? NaN : column("error")) nooutput
low = range[1] > 0 ? range[1] : 10.0**(floor(log10(STATS_min)) - 0.3)
high = range[2] > 0 ? range[2] : 10.0**(ceil(log10(STATS_max)) + 0.3)
set yrange [low:high]
if (timed > 0 && range[3] > 0) { set xrange [range[3]:range[4]] }
if (range[6] > low) {
  set object 1 rectangle from graph 0, graph 0 to graph 1, first (range[6] < high ? range[6] : high) \
      fc rgb "#EEEEEE" fs solid noborder behind
  set label 1 "grey: less than 100 times the reference's uncertainty, " . gprintf("%.0t·10^{%T}", range[5]) \
      at graph 0.99, graph 0.03 right font ",11" textcolor rgb "#606060"
}
top = high / (high / low)**0.03
set rmargin screen 0.70
set key at screen 0.715, screen 0.95 left top vertical Left reverse nobox font ",12" samplen 3
known(m) = strcol("method") eq m && strcol("state") eq "known"
drawn(m) = strcol("method") eq m && strcol("state") ne "failed"
vague(m) = strcol("method") eq m && strcol("state") eq "vague"
failed(m) = strcol("method") eq m && strcol("state") eq "failed"
plot for [i = 1:n] ARG1 using (drawn(method[i]) ? across("median") : NaN):"error" with linespoints lt i \
         title method[i] . (runs[i] > 0 ? "" : ": all failed"), \
     for [i = 1:n] ARG1 using (known(method[i]) && timed > 0 ? across("median") : NaN):"error":(across("q1")):(across("q3")) \
         with xerrorbars lt i ps 0 dt solid lw 1.2, \
     for [i = 1:n] ARG1 using (vague(method[i]) ? across("median") : NaN):"error" with points lt i lc rgb "#B0B0B0", \
     for [i = 1:n] ARG1 using (failed(method[i]) ? across("median") : NaN):(top) with points lt i pt 2 ps 1.6 lw 2.4, \
     NaN with points pt 2 ps 1.6 lw 2.4 lc rgb "#606060" title (failures > 0 ? "failed" : ""), \
     ARG3 using (strcol("what") eq "slope" ? column("x1") : NaN):"y1":(column("x2") - column("x1")):(column("y2") - column("y1")) \
         with vectors nohead lc rgb "#606060" lw 1.4, \
     ARG3 using (strcol("what") eq "slope" ? column("x2") : NaN):"y2":(strcol("text")) \
         with labels left offset 0.6,-0.9 font ",11" textcolor rgb "#606060"
