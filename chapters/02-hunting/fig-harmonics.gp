load "style.gp"
set output ARG2
set logscale xy
set xrange [0.9:110]
set yrange [1e-9:0.2]
set format y "10^{%T}"
set xtics (1, 3, 5, 9, 15, 23, 47, 95)
set xlabel "highest harmonic (odd harmonics only)"
set multiplot layout 1,2
set key bottom left
set label 1 "reconstructed profiles" at graph 0.98, graph 0.96 right tc rgb grey
set ylabel "relative error of the amplitude"
plot for [i = 0:3] ARG1 every :::i::i using "highest":"amplitude_error" with linespoints lt i+1 \
       title word("new-150 CN-131.5 Heumann-87.4 friction-100", i+1)
set ylabel "relative error of the frequency"
unset key
plot for [i = 0:3] ARG1 every :::i::i using "highest":"omega_error" with linespoints lt i+1
unset multiplot
