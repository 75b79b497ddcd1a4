load "style.gp"
set output ARG2
set terminal pngcairo size 1200,480
set multiplot layout 1,2
set logscale x
set xrange [0.001:0.5]
set xlabel "wavenumber, cycle/ft"
set yrange [0.6:1.02]
set ylabel "gain of both, BC"
set key bottom left title "chosen: corner 1 Hz" left
plot ARG1 using "phi_cycle_per_ft":"limit" with lines lt 6 lw 5 title "limit, sin(θ/2)/(θ/2)", \
     ARG1 using "phi_cycle_per_ft":"slow" with lines lt 2 title "9 mph", \
     ARG1 using "phi_cycle_per_ft":"fast" with lines lt 3 title "80 mph"
set yrange [0:5]
set ylabel "gain less its limit, thousandths"
set key top left notitle
plot ARG1 using "phi_cycle_per_ft":(1000 * (column("slow") - column("limit"))) with lines lt 2 title "9 mph", \
     ARG1 using "phi_cycle_per_ft":(1000 * (column("fast") - column("limit"))) with lines lt 3 title "80 mph"
unset multiplot
