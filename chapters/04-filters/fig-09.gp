# alt: Left, the gain of both filters falls from 1 for long waves to 0.64 at half a cycle per foot; the curves for 9 and 80 mph and their limit lie on each other.
# alt: Right, the difference from the limit in thousandths: it grows towards short waves, to 4.7 at 9 mph, and stays below 0.1 at 80 mph.
load "style.gp"
set terminal pngcairo size 740,300 font "DejaVu Sans,11"
set output ARG2
unset key
set multiplot layout 1,2
set logscale x
set xrange [0.001:0.5]
set xtics (0.001, 0.01, 0.1, 0.5)
set xlabel "wavenumber, cycle/ft"
set yrange [0.6:1.02]
set ylabel "gain of both, BC"
set label 1 "9 mph, 80 mph\nand the limit κ → 0" at 0.0015,0.80 font ",11"
set arrow 1 from 0.03,0.79 to 0.155,0.945 filled size screen 0.012,20 lw 1.2 lc rgb grey
plot ARG1 using "phi_cycle_per_ft":"limit" with lines lc rgb light lw 7 dt solid, \
     ARG1 using "phi_cycle_per_ft":"slow" with lines lt 2, \
     ARG1 using "phi_cycle_per_ft":"fast" with lines lt 3
unset arrow 1
set yrange [0:5]
set ylabel "gain minus its limit, thousandths"
set label 1 "9 mph" at 0.13,2.2 right font ",11" textcolor rgb blue
set label 2 "80 mph" at 0.06,0.22 right font ",11" textcolor rgb "#A84300"
plot ARG1 using "phi_cycle_per_ft":(1000 * (column("slow") - column("limit"))) with lines lt 2, \
     ARG1 using "phi_cycle_per_ft":(1000 * (column("fast") - column("limit"))) with lines lt 3
unset multiplot
