# alt: Five parallel curves on logarithmic axes rise with the wavelength, at both ends with its square and with a shoulder from 2 to 20 m, the one for 40 km/h highest and the one for 177 km/h lowest. They do not cross.
load "style.gp"
set terminal pngcairo size 740,330 font "DejaVu Sans,11"
set minussign
set output ARG2
unset key
set logscale xy
set xrange [0.5:1000]
set yrange [0.01:1e4]
set format y "10^{%T}"
set xlabel "wavelength λ, m"
set ylabel "allowed amplitude, cm"
set rmargin 3.5
set label "40 km/h" at 1.1,2.3 center font ",10"
set label "177 km/h" at 1.1,0.05 left font ",10" textcolor rgb "#8A3A70"
set label "between them 64, 100 and 130 km/h" at 9,0.6 left font ",10"
plot for [i=0:4] ARG1 using (column("speed_kmh") == word("40 64 100 130 177",i+1) ? column("wavelength_m") : NaN):"amplitude_cm" \
       with lines lt i+1 dt 1 lw 1.8
