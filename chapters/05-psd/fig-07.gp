# alt: The spectrum of zone 10 twice. On linear axes a peak stands out of a curve that falls steeply
# alt: at long waves; on logarithmic axes two straight slopes carry a row of peaks. Points of an
# alt: estimate lie on the sum.
load "style.gp"
set terminal pngcairo size 1400,540
set output ARG2
set multiplot layout 1,2
set lmargin 15
set xlabel "wavenumber φ, cycle/m"
set ylabel "S_z, m²/(cycle/m)"
set title "(a) linear axes"
set xrange [0:0.3]
set yrange [0:1.5e-3]
set format y "%.1t·10^{%T}"
set ytics add ("0" 0)
plot ARG3 using "phi_cycle_per_m":"S" with points lc rgb red pt 6 ps 0.9 title "estimate", \
     ARG1 using "phi_cycle_per_m":"S_composite" with lines lt 1 title "composite", \
     ARG1 using "phi_cycle_per_m":"S_random" with lines lt 2 title "random", \
     ARG1 using "phi_cycle_per_m":"S_periodic" with lines lt 4 title "periodic"
set title "(b) logarithmic axes"
set ytics autofreq
unset key
set logscale xy
set format y "10^{%L}"
set xrange [0.01:1.6]
set yrange [1e-9:1e-2]
plot ARG3 using "phi_cycle_per_m":"S" with points lc rgb red pt 6 ps 0.6 title "estimate", \
     ARG1 using "phi_cycle_per_m":"S_composite" with lines lt 1 title "composite", \
     ARG1 using "phi_cycle_per_m":"S_random" with lines lt 2 title "random", \
     ARG1 using "phi_cycle_per_m":"S_periodic" with lines lt 4 title "periodic"
unset multiplot
