# alt: A bell-shaped peak above a falling random part. A box as high as the peak and as wide as the
# alt: peak is at half its height stands over it; arrows mark height and width.
load "style.gp"
set terminal pngcairo size 1000,460
set output ARG2
stats ARG4 using "phi_0" name "P" nooutput
stats ARG4 using "S_under" name "L" nooutput
stats ARG4 using "S_peak" name "H" nooutput
stats ARG3 using "phi_cycle_per_m" name "B" nooutput
set xrange [0.055:0.115]
set yrange [0:5e-4]
set format y "%.1t·10^{%T}"
set ytics add ("0" 0)
set xlabel "wavenumber φ, cycle/m"
set ylabel "S_z, m²/(cycle/m)"
set lmargin 15
set key top right
phi = P_max
half = 0.5 * (L_max + H_max)
set arrow from B_min, half to B_max, half heads lw 1.8 lc rgb blue
set arrow from phi, L_max to phi, H_max heads lw 1.8 lc rgb red
set arrow from phi, 0 to phi, L_max nohead ls guide
set label "C_1" at phi + 0.0005, L_max + 0.75 * (H_max - L_max) tc rgb red
set label "β" at phi - 0.0025, half * 1.05 tc rgb blue
set label "half of C_1" at B_max + 0.001, half tc rgb blue
set label "φ_0" at phi + 0.0005, 0.15e-4 tc rgb "#606060"
plot ARG1 using "phi_cycle_per_m":"S_total" with lines lt 1 title "zone 7, seen through the window", \
     ARG1 using "phi_cycle_per_m":"S_random" with lines lt 2 title "random part", \
     ARG3 using "phi_cycle_per_m":"S" with lines lt 4 title "area βC_1 of equation (6)"
