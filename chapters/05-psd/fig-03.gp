# alt: A spectrum on logarithmic axes. A single segment scatters over decades; the average over five
# alt: miles and triangles for bands lie on the model, which falls with slope -2 to the corner and
# alt: with slope -4 beyond.
load "style.gp"
set terminal pngcairo size 1000,460
set output ARG2
set logscale xy
set xrange [0.006:1.6]
set yrange [1e-10:1e-1]
set format y "10^{%L}"
set key bottom left Left reverse
set xlabel "wavenumber φ, cycle/m"
set ylabel "S_z, m²/(cycle/m)"
set label "corner φ_c" at 0.1,1.6e-4
set arrow from 0.12,1e-4 to 0.12,2.2e-5 head filled size screen 0.01,20 lc rgb black
set label "slope −2" at 0.02,2e-3
set label "slope −4" at 0.5,5e-7
plot ARG1 using "phi_cycle_per_m":"S_one" with lines lc rgb light lw 1 title "one segment of 4096 ft", \
     ARG1 using "phi_cycle_per_m":"S_five_miles" with lines lc rgb blue lw 1 title "average over five miles", \
     ARG1 using "phi_cycle_per_m":"S_model" with lines lt 1 title "equation (4)", \
     ARG3 using "phi_cycle_per_m":"S" with points lt 3 ps 0.9 title "five miles and bands, 6 an octave"
