# alt: Five curves rise with the square of the wavelength up to a few metres, are level at 1.6 cm between, and rise again with the square beyond. Upright lines mark the 7 and 100 m that the paper prints.
load "style.gp"
set terminal pngcairo size 740,330 font "DejaVu Sans,11"
set output ARG2
unset key
set logscale xy
set xrange [0.5:1000]
set yrange [0.01:1000]
set format y "%g"
set xlabel "wavelength λ, m"
set ylabel "allowed amplitude, cm"
set rmargin 3.5
set arrow from 7,0.01 to 7,1000 nohead ls guide
set arrow from 100,0.01 to 100,1000 nohead ls guide
set label "the paper's 7 m" at 7.5,0.016 font ",10"
set label "the paper's 100 m" at 108,0.016 font ",10"
set label "wheel force" at 0.6,4 font ",11"
set label "stroke: level" at 13,2.6 center font ",11"
set label "stroke: rise" at 20,60 font ",11"
set label "40 km/h" at 0.85,1.75 center font ",10"
set label "177 km/h" at 2.1,0.22 left font ",10" textcolor rgb "#8A3A70"
set label "40" at 22,1.1 center font ",10"
set label "64" at 35.5,1.1 center font ",10" textcolor rgb blue
set label "100" at 54,1.1 center font ",10" textcolor rgb "#A84300"
set label "130" at 76,1.1 center font ",10" textcolor rgb "#00694B"
set label "177 km/h" at 106,1.1 left font ",10" textcolor rgb "#8A3A70"
plot for [i=0:4] ARG1 using (column("speed_kmh") == word("40 64 100 130 177",i+1) ? column("wavelength_m") : NaN):"amplitude_cm" \
       with lines lt i+1 dt 1 lw 1.8
