# alt: Run time against the mass of the rail. The explicit methods rise steeply below 1 kg, the
# alt: implicit one stays level.
load "style.gp"
set output ARG2
methods = "'order 5: no search' 'order 8 (GSL)' 'Radau IIA'"
of(m, c) = strcol("method") eq word(methods, m) ? column(c) : NaN
timed = 0
set yrange [0:2]
set table $unused
plot ARG1 using (timed = timed + (column("seconds") > 0), 1)
unset table
set autoscale y
set terminal pngcairo size 1200,(timed > 0 ? 900 : 500)
set multiplot layout (timed > 0 ? 2 : 1),1
set lmargin 11
set rmargin 28
set logscale xy
set format "10^{%T}"
set xrange [2e3:5e-4]
set key outside right top
set ylabel "run time, s"
if (timed > 0) {
  plot for [m = 1:3] ARG1 using "mass_kg":(of(m, "seconds")) with points lt m title word(methods, m)
  unset key
}
set xlabel "mass of the rail, kg"
set ylabel "evaluations"
plot for [m = 1:3] ARG1 using "mass_kg":(of(m, "evaluations")) with points lt m title word(methods, m)
unset multiplot
