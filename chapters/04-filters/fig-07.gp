# alt: Two curves that are 1 for long waves and fall towards short ones. The one for 80 mph falls from 0.0085 cycles per foot on, the one for 9 mph from 0.076 on.
load "style.gp"
set terminal pngcairo size 740,300 font "DejaVu Sans,11"
set output ARG2
unset key
set logscale xy
set xrange [0.001:0.5]
set yrange [0.01:1.5]
set format y "%g"
set xlabel "wavenumber, cycle/ft"
set ylabel "gain of the analog filter B"
set label "9 mph" at 0.2,0.5 font ",11" textcolor rgb blue
set label "80 mph" at 0.036,0.26 font ",11" textcolor rgb "#A84300"
set label "corner of 1 Hz" at 0.0030,0.40 center font ",10"
set label "corner of 1 Hz" at 0.0355,0.62 center font ",10"
set arrow from 0.0048,0.46 to 0.0079,0.66 filled size screen 0.012,20 lw 1.2 lc rgb grey
set arrow from 0.058,0.64 to 0.071,0.68 filled size screen 0.012,20 lw 1.2 lc rgb grey
set rmargin 2
plot ARG1 using "phi_cycle_per_ft":"slow" with lines lt 2, \
     ARG1 using "phi_cycle_per_ft":"fast" with lines lt 3, \
     ARG3 using "phi_cycle_per_ft":"gain" with points pt 7 ps 1.1 lc rgb "#404040"
