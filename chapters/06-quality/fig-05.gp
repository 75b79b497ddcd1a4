load "style.gp"
set output ARG2
set logscale xy
set xrange [1:1000]
set yrange [0.5:1000]
set format y "%g"
set key top left title "speeds reconstructed"
set xlabel "wavelength, m"
set ylabel "allowed amplitude, cm"
set label "1.6 cm, printed" at 2,1.2
plot for [i=0:4] ARG1 using (column("speed_kmh") == word("40 64 100 130 177",i+1) ? column("wavelength_m") : NaN):"amplitude_cm" \
       with lines lt i+1 dt 1 title word("40 64 100 130 177",i+1)." km/h"
