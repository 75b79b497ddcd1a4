load "style.gp"
set output ARG2
set logscale x
set xrange [*:*] reverse
set autoscale xfix
set xlabel "wavelength, mm"
set ylabel "level, dB re 1 μm"
set tmargin 5
set key above horizontal maxrows 3
stats ARG1 using 1:2 nooutput
plot for [i=0:STATS_blocks-1] ARG1 using 1:2 index i with linespoints lt i+1 title columnheader(3)
