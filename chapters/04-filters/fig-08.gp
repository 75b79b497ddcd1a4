# alt: Two curves that are 1 for long waves and rise towards short ones, to 4 at 9 mph and to 37 at 80 mph. Two thin ones rise with them, turn at a fifth of a cycle per foot and fall.
load "style.gp"
set terminal pngcairo size 740,310 font "DejaVu Sans,11"
set output ARG2
unset key
set logscale xy
set xrange [0.001:0.5]
set yrange [0.5:60]
set format y "%g"
set xlabel "wavenumber, cycle/ft"
set ylabel "gain of the digital filter C"
set label "9 mph" at 0.09,1.05 font ",11" textcolor rgb blue
set label "80 mph" at 0.024,4.6 right font ",11" textcolor rgb "#A84300"
set label "thin: followed by a mean\nover three samples" at 0.0012,30 font ",10"
set rmargin 2
plot ARG1 using "phi_cycle_per_ft":"slow" with lines lt 2, \
     ARG1 using "phi_cycle_per_ft":"fast" with lines lt 3, \
     ARG1 using "phi_cycle_per_ft":"slow_band" with lines lt 2 lw 1.1, \
     ARG1 using "phi_cycle_per_ft":"fast_band" with lines lt 3 lw 1.1
