load "style.gp"
set output ARG2
set logscale xy
set xrange [0.5:1000]
set yrange [0.01:1000]
set format y "%g"
set key top left title "car and speeds reconstructed"
set xlabel "wavelength, m"
set ylabel "allowed amplitude, cm"
plot for [i=0:4] ARG1 using (column("speed_kmh") == word("40 64 100 130 177",i+1) ? column("wavelength_m") : NaN):"amplitude_cm" \
       with lines lt i+1 title word("40 64 100 130 177",i+1)." km/h"
