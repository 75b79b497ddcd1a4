load "style.gp"
set output ARG2
set key top left
set logscale xy
set xrange [1:1000]
set yrange [0.5:1000]
set format y "%g"
set xlabel "wavelength, m"
set ylabel "allowed amplitude, cm"
set arrow from 1,2.54 to 1000,2.54 nohead ls guide
set label "2.54 cm" at 700,3.3 right
plot ARG1 using "wavelength_m":"amplitude_cm" with lines lt 1 title "0.5 Hz, damping 0.2, 100 km/h", \
     ARG3 using "wavelength_m":"amplitude_cm" with points ls printed title "resonance as printed"
