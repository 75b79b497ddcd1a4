# alt: Three spectra near the line of the rail. Left: its peak on a broad floor for random dips, and
# alt: on wide skirts for grouped ones. Middle: a second, lower peak at one over 33 ft. Right: a
# alt: lower peak on each side at the same distance.
load "style.gp"
set terminal pngcairo size 1400,460
set output ARG2
set multiplot layout 1,3
set tmargin 4
set logscale y
set format y "10^{%L}"
set xrange [0.05:0.13]
set xtics 0.02
set yrange [1e-7:1]
set ylabel "S_z, m²/(cycle/m)"
set xlabel "wavenumber φ, cycle/m"
set key top right samplen 2
set label 1 "φ_0" at first 0.08413, graph 1.05 center
set title "(a) broadening by uneven joints" offset 0,0.7
plot ARG1 using "phi_cycle_per_m":"random" with lines lt 1 title "random dips", \
     ARG1 using "phi_cycle_per_m":"grouped" with lines lt 2 title "grouped dips"
unset key
unset ylabel
set title "(b) linear ballast memory" offset 0,0.7
set label 2 "1/(33 ft)" at first 0.09942, graph 1.05 center
plot ARG1 using "phi_cycle_per_m":"single" with lines lt 1
set title "(c) nonlinear ballast memory" offset 0,0.7
set label 2 "φ_0+ε"
set label 3 "φ_0−ε" at first 0.06883, graph 1.05 center
plot ARG1 using "phi_cycle_per_m":"pair" with lines lt 1
unset multiplot
