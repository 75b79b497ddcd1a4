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
set xrange [0.3 * STATS_min_x:3 * STATS_max_x]
set yrange [0.3 * STATS_min_y:3 * STATS_max_y]
set tmargin 3.5
set key at graph 0, 1.02 left bottom Left reverse horizontal nobox  # above the axes, where no data are
plot x with lines ls guide title "true = stated", \
     ARG1 using (column("covered") > 0 ? column("stated") : NaN):"truth" with points lt 2 title sprintf("within: %.0f of %.0f", good, all), \
     ARG1 using (column("covered") > 0 ? NaN : column("stated")):"truth" with points lt 3 title (good < all ? sprintf("beyond: %.0f", all - good) : "")
