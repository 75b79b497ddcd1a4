load "style.gp"
set output ARG2
set logscale xy
set xrange [1:300]
set yrange [0.1:100]
set format y "%g"
set key top left title "100 km/h, stops reconstructed"
set xlabel "wavelength, m"
set ylabel "allowed amplitude, cm"
plot for [i=1:4] ARG1 using (column("kappa") == word("0 1 10 100",i) ? column("wavelength_m") : NaN):"amplitude_cm" \
     with lines lt i title i == 1 ? "linear, as Figure 4" : "κ = ".word("0 1 10 100",i), \
     for [i=2:4] ARG3 using (column("kappa") == word("0 1 10 100",i) ? column("wavelength_m") : NaN):"amplitude_cm" \
     with lines lt i lw 1.2 dt 3 notitle, \
     NaN with lines lc "black" lw 1.2 dt 3 title "harmonic balance"
