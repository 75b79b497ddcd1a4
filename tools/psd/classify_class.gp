load "style.gp"
set output ARG2
set xrange [0:*]
set yrange [0:*]
set xlabel "joint dip B (printed convention), mm"
set ylabel "roughness A, 10^{-6} m^2 cycle/m"
plot for [m = 1:6] ARG1 using (column("class") == m ? column("B_mm") : NaN):(1e6 * column("A_m2_cycle_per_m")) \
       with lines lt m title sprintf("limit of class %d", m), \
     ARG3 using "B_mm":(1e6 * column("A_m2_cycle_per_m")):"B_error_mm":(1e6 * column("A_error")) with xyerrorbars lc rgb red dt solid pt 7 ps 1.6 lw 2.4 title "this track"
