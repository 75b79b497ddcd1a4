load "style.gp"
set output ARG2
unset key
set logscale xy
set xrange [1:1000]
set yrange [0.5:1000]
set format y "%g"
set xlabel "wavelength, m"
set ylabel "allowed amplitude, cm"
plot ARG1 using "wavelength_m":"amplitude_cm" with lines lt 1
