# alt: The spectrum of a slow line falls with the square of the spatial frequency and then with its fourth power. The squared allowed amplitude, at a height that is fitted, falls with the fourth power, is level, and falls again.
load "style.gp"
set terminal pngcairo size 740,370 font "DejaVu Sans,11"
set output ARG2
unset key
set logscale xy
set xrange [0.01:0.5]
set yrange [1e-7:0.1]
set format y "10^{%L}"
set format x "%g"
set xtics add (0.02, 0.05, 0.2, 0.5)
set rmargin 2.5
set xlabel "spatial frequency φ, cycle/m"
set ylabel "density, m²/(cycle/m); heights of A² fitted"
set label "a 48-km/h\nbranch line" at 0.17,6e-6 right font ",11"
set label "allowed A²,\nbands of equal width" at 0.05,1.2e-5 right font ",11" textcolor rgb blue
set label "A²/φ,\nbands in equal ratios" at 0.0185,2.2e-2 font ",11" textcolor rgb "#A84300"
plot ARG1 using "phi_cycle_per_m":"psd" with lines lt 1, \
     ARG1 using "phi_cycle_per_m":"squared" with lines lt 2, \
     ARG1 using "phi_cycle_per_m":"relative" with lines lt 3
