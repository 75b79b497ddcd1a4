# alt: The allowed amplitude against wavelength is 2.5 cm for short waves, dips to 1 cm near 55 m and rises with the square of the wavelength beyond.
load "style.gp"
set terminal pngcairo size 740,310 font "DejaVu Sans,11"
set output ARG2
unset key
set logscale xy
set xrange [1:1000]
set yrange [0.5:1000]
set format y "%g"
set xlabel "wavelength λ, m"
set ylabel "allowed amplitude, cm"
set rmargin 3.5
set arrow from 1,2.54 to 1000,2.54 nohead ls guide
set label "stroke limit, 2.54 cm" at 700,3.6 right font ",10"
set label "resonance as printed" at 64,0.95 font ",10" textcolor rgb "#A84300"
plot ARG1 using "wavelength_m":"amplitude_cm" with lines lt 1, \
     ARG3 using "wavelength_m":"amplitude_cm" with points ls printed
