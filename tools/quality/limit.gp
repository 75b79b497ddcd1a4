load "style.gp"
set output ARG2
set logscale xy
set xrange [0.5:1000]
set format y "%g"
set key top left
set xlabel "wavelength, m"
set ylabel "allowed amplitude, cm"
plot ARG1 using "wavelength_m":"amplitude_cm" with lines lt 1 lw 10 lc rgb light title "what counts", \
     ARG1 using "wavelength_m":"stroke_cm" with lines lt 2 title "stroke", \
     ARG1 using "wavelength_m":"force_cm" with lines lt 3 title "wheel force"
