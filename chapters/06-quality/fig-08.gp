load "style.gp"
set output ARG2
set logscale xy
set xrange [0.001:1]
set yrange [1e-9:1e4]
set format y "10^{%L}"
set format x "%g"
set key top right title "spectrum of another line, car rebuilt"
set xlabel "spatial frequency, cycle/m"
set ylabel "density, m²/(cycle/m); heights of A² fitted"
plot ARG1 using "phi_cycle_per_m":"psd" with lines lt 1 title "a 48-km/h branch line", \
     ARG1 using "phi_cycle_per_m":"squared" with lines lt 2 title "allowed A², bands of equal width", \
     ARG1 using "phi_cycle_per_m":"relative" with lines lt 3 title "A²/φ, bands in equal ratios"
