# alt: Five curves like the one before, for 20 to 100 km/h, dip to the same 1 cm at five wavelengths between 11 and 53 m. A thick line runs along their lowest parts: level up to 53 m, then rising.
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
set label "the least over all\nspeeds up to 100 km/h" at 130,4 font ",11"
set label "at 20" at 10.2,0.78 right font ",10" textcolor rgb grey
set label "40" at 21.3,0.78 center font ",10" textcolor rgb grey
set label "60" at 32,0.78 center font ",10" textcolor rgb grey
set label "80" at 42.6,0.78 center font ",10" textcolor rgb grey
set label "100 km/h" at 50,0.78 left font ",10" textcolor rgb blue
plot for [i=0:3] ARG3 using (column("speed_kmh") == 20*(i+1) ? column("wavelength_m") : NaN):"amplitude_cm" \
       with lines lc rgb grey lw 1.4 dt solid, \
     ARG3 using (column("speed_kmh") == 100 ? column("wavelength_m") : NaN):"amplitude_cm" with lines lt 2 lw 1.8 dt 2, \
     ARG1 using "wavelength_m":"amplitude_cm" with lines lt 1 lw 3.6
