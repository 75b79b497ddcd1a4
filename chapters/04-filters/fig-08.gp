load "style.gp"
set output ARG2
set logscale xy
set xrange [0.001:0.5]
set yrange [0.5:100]
set xlabel "wavenumber, cycle/ft"
set ylabel "gain of the digital filter C"
set key top left title "chosen: corner 1 Hz" left
plot ARG1 using "phi_cycle_per_ft":"slow" with lines lt 2 title "9 mph", \
     ARG1 using "phi_cycle_per_ft":"fast" with lines lt 3 title "80 mph", \
     ARG1 using "phi_cycle_per_ft":"slow_band" with lines lt 2 lw 1 dt 2 title "9 mph, and a mean over three samples", \
     ARG1 using "phi_cycle_per_ft":"fast_band" with lines lt 3 lw 1 dt 2 title "80 mph, and the same mean"
