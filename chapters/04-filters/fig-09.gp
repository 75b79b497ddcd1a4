load "style.gp"
set output ARG2
set logscale xy
set xrange [0.001:0.5]
set yrange [0.05:2]
set xlabel "wavenumber, cycle/ft"
set ylabel "gain of both, BC"
set key bottom left title "reconstructed: corner 1 Hz" left
plot ARG1 using "phi_cycle_per_ft":"limit" with lines lt 6 title "limit, sin(θ/2)/(θ/2)", \
     ARG1 using "phi_cycle_per_ft":"slow" with lines lt 2 title "9 mph", \
     ARG1 using "phi_cycle_per_ft":"fast" with lines lt 3 title "80 mph", \
     ARG3 using "phi_cycle_per_ft":"slow" with points ls other title "driven by sines", \
     ARG3 using "phi_cycle_per_ft":"fast" with points ls other, \
     ARG1 using "phi_cycle_per_ft":"slow_smoothed" with lines lt 7 title "9 mph, times fixed low-pass D", \
     ARG1 using "phi_cycle_per_ft":"fast_smoothed" with lines lt 8 title "80 mph, times fixed low-pass D"
