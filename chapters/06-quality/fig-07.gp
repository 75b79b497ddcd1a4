load "style.gp"
set output ARG2
set logscale xy
set xrange [0.5:1000]
set yrange [0.01:1000]
set format y "%g"
set key top left title "car and speeds reconstructed"
set xlabel "wavelength, m"
set ylabel "allowed amplitude, cm"
set arrow from 7,0.01 to 7,1000 nohead ls guide
set arrow from 100,0.01 to 100,1000 nohead ls guide
set label "printed: 7 m" at 7.5,0.02
set label "printed: 100 m" at 108,0.02
plot for [i=0:4] ARG1 using (column("speed_kmh") == word("40 64 100 130 177",i+1) ? column("wavelength_m") : NaN):"amplitude_cm" \
       with lines lt i+1 dt 1 title word("40 64 100 130 177",i+1)." km/h"
