# alt: Three panels of errors against cells on double logarithmic axes, for the two forces and the moment; the errors of the six cases fall with more cells, not evenly.
load "style.gp"
set output ARG2
set terminal pngcairo size 1100,440 font "DejaVu Sans,13" enhanced background rgb "white"
set datafile missing NaN
array name[6]
keep(k, text) = (k >= 1 && k <= 6 ? (name[k] = text) : 0, 1)
set yrange [0:2]
set table $unused
plot ARG1 using (keep(int(column("case")), strcol("shape_and_spin")))
unset table
set multiplot layout 1,3 margins 0.08,0.985,0.15,0.84 spacing 0.085
set logscale xy
unset key
set label 7 "slope −2" at 30,0.006 left tc rgb "#606060"
set xrange [5:*]
set yrange [1e-5:0.1]
set format y "10^{%T}"
set xtics (6,12,24,48,96)
set xlabel "cells along, and rows"
# Columns 4 to 6 are the distances, 7 to 9 what the limits are known to; what they do not know 100 times better is grey.
do for [q = 1:3] {
  set ylabel "distance of " . word("fx fy mz", q) . " from its limit"
  if (q == 1) { do for [k = 1:6] { set label k name[k] at screen 0.1+0.3*((k-1)/2), screen 0.97-0.06*((k-1)%2) point lt k offset 1.2,0 } } else { do for [k = 1:6] { unset label k } }
  plot for [k = 1:6] ARG1 using "cells":(column("case") == k ? column(3 + q) : NaN) with linespoints lt k lw 1, \
       ARG1 using "cells":(column(3 + q) < 100 * column(6 + q) ? column(3 + q) : NaN) with points pt 7 ps 1.3 lc rgb light, \
       2 / x**2 with lines ls guide
}
unset multiplot
