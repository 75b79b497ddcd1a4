# alt: Friction against normal load at four creeps and in full slip. All five lines fall with the load; the points of the four tests scatter about them, because each test has its own wear.
load "style.gp"
set output ARG2
set terminal pngcairo size 740,290 font "DejaVu Sans,12" enhanced background rgb "white"
set xlabel "normal load, lbf"
set ylabel "friction coefficient µ"
set xrange [400:2680]
set yrange [0:0.62]
set rmargin 17
unset key
set label "synthetic: lines for equal wear, points with the wear of each test" at graph 0.02, 1.04 tc rgb "#BE5400"
creep = "0.0005 0.001 0.002 0.004"
do for [k=2:5] {
  stats ARG1 using k nooutput
  set label "creep ".word(creep, k-1) at 2740,STATS_min left
}
stats ARG1 using 6 nooutput
set label "largest, µ_c" at 2740,STATS_min left
plot for [k=2:6] ARG1 using 1:k with lines lt k-1, for [k=2:6] ARG3 using 1:k with points lt k-1
