load "style.gp"
set output ARG2
set logscale xy
set xrange [1:1000]
set yrange [0.5:1000]
set format y "%g"
set key top left
set xlabel "wavelength, m"
set ylabel "allowed amplitude, cm"
plot for [i=0:4] ARG3 using (column("speed_kmh") == 20*(i+1) ? column("wavelength_m") : NaN):"amplitude_cm" \
       with lines lt i+2 lw 1.8 title sprintf("at %d km/h", 20*(i+1)), \
     ARG1 using "wavelength_m":"amplitude_cm" with lines lt 1 lw 3.2 title "all speeds to 100 km/h"
