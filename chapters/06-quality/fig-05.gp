# alt: Five curves that are level at 1.6 cm for short waves and rise with the square of the wavelength beyond 21 m at 40 km/h and 94 m at 177 km/h.
load "style.gp"
set terminal pngcairo size 740,330 font "DejaVu Sans,11"
set output ARG2
unset key
set logscale xy
set xrange [1:1000]
set yrange [0.5:1000]
set format y "%g"
set xlabel "wavelength λ, m"
set ylabel "allowed amplitude, cm"
set rmargin 3.5
set label "1.6 cm, printed" at 1.2,1.2 font ",10"
set label "40" at 22,1.2 center font ",10"
set label "64" at 35.5,1.2 center font ",10" textcolor rgb blue
set label "100" at 54,1.2 center font ",10" textcolor rgb "#A84300"
set label "130" at 75,1.2 center font ",10" textcolor rgb "#00694B"
set label "177 km/h" at 91,1.2 left font ",10" textcolor rgb "#8A3A70"
plot for [i=0:4] ARG1 using (column("speed_kmh") == word("40 64 100 130 177",i+1) ? column("wavelength_m") : NaN):"amplitude_cm" \
       with lines lt i+1 dt 1 lw 2
