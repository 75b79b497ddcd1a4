load "style.gp"
set output ARG2
set xrange [0:*]
set yrange [0:*]
set format y "%.1e"
set lmargin 12
set xlabel "joint dip B (printed convention), mm"
set ylabel "roughness A, m^2 cycle/m" offset -1
plot for [m = 1:6] ARG1 using (column("class") == m ? column("B_mm") : NaN):"A_m2_cycle_per_m" \
       with lines lt m title sprintf("limit of class %d", m), \
     ARG3 using "B_mm":"A_m2_cycle_per_m":"B_error_mm":"A_error" with xyerrorbars lc rgb red dt solid pt 7 ps 1.6 lw 2.4 title "this track"
