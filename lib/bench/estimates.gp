# What solvers say of their error, and what it is: ARG1 of bench::estimates_against_truth, ARG2 the PNG.
load "style.gp"
set output ARG2

set logscale xy
set format "10^{%T}"
set xlabel "stated error"
set ylabel "true error"
stats ARG1 using (column("covered")) nooutput
good = STATS_sum
all = STATS_records
stats ARG1 using (column("stated")):(column("truth")) nooutput
low = 0.3 * (STATS_min_x < STATS_min_y ? STATS_min_x : STATS_min_y)
high = 3 * (STATS_max_x > STATS_max_y ? STATS_max_x : STATS_max_y)
set xrange [low:high]
set yrange [low:high]
set key at graph 0.02, 0.91 left top Left reverse # above the line, where points are few
set label 1 sprintf("%.0f of %.0f within what is stated", good, all) at graph 0.03, 0.94
plot x with lines ls guide title "true = stated", \
     ARG1 using (column("covered") > 0 ? column("stated") : NaN):"truth" with points lt 2 title "within", \
     ARG1 using (column("covered") > 0 ? NaN : column("stated")):"truth" with points lt 3 title "beyond"
