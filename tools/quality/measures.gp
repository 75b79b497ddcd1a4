load "style.gp"
set output ARG2
set autoscale xfix
set yrange [0:*]
set xlabel "distance, km"
set ylabel "standard deviation of a section, mm"
set tmargin 5
set key above horizontal maxrows 3
stats ARG1 using 1:2 nooutput
plot for [i=0:STATS_blocks-1] ARG1 using 1:2 index i with lines lt i+1 title columnheader(3)
