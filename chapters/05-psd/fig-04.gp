load "style.gp"
set terminal pngcairo size 1000,850
set output ARG2
set multiplot layout 3,1
set lmargin 11
set tmargin 3.4
set logscale y
set format y "10^{%L}"
set xrange [0.05:0.13]
set ylabel "S, m²/(cycle/m)"
set key top right maxrows 2
set label 1 "φ_0" at first 0.08413, graph 1.05 center
set title "(a) broadening by uneven joints" offset 0,0.6
set yrange [1e-6:3e1]
plot ARG3 using "phi_cycle_per_m":"random" with lines lt 1 title "random dips", \
     ARG3 using "phi_cycle_per_m":"grouped" with lines lt 2 title "groups of five joints", \
     ARG1 using "phi_cycle_per_m":"random" with points lc rgb black pt 6 ps 0.8 title "random, measured", \
     ARG1 using "phi_cycle_per_m":"grouped" with points lc rgb blue pt 4 ps 0.8 title "groups, measured"
set title "(b) one sideband: linear ballast memory" offset 0,0.6
set yrange [1e-7:3e-2]
set label 2 "1/(33 ft)" at first 0.09942, graph 1.05 center
plot ARG3 using "phi_cycle_per_m":"single" with lines lt 1 title "closed form", \
     ARG1 using "phi_cycle_per_m":"single" with points lc rgb red pt 6 ps 0.9 title "measured"
set title "(c) two sidebands: nonlinear ballast memory" offset 0,0.6
set label 2 "φ_0+ε"
set label 3 "φ_0−ε" at first 0.06883, graph 1.05 center
set xlabel "wavenumber φ, cycle/m"
plot ARG3 using "phi_cycle_per_m":"pair" with lines lt 1 title "closed form", \
     ARG1 using "phi_cycle_per_m":"pair" with points lc rgb red pt 6 ps 0.9 title "measured"
unset multiplot
