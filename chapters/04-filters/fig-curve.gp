load "style.gp"
set output ARG2
set terminal pngcairo size 1100,800
set multiplot layout 2,1
set lmargin 10
set xrange [3700:5900]
set key outside top center horizontal nobox
on(v, y) = (column("mph") == v ? y : NaN)
set ylabel "curvature, deg per 100 ft"
set yrange [-5:0.6]
plot ARG1 using "x_ft":(on(80, column("curvature_true"))) with lines lc rgb light dt solid lw 8 title "truth", \
     ARG1 using "x_ft":(on(80, column("curvature_deg_per_100ft"))) with lines lt 1 lw 1.8 title "80 mph", \
     ARG1 using "x_ft":(on(9, column("curvature_deg_per_100ft"))) with lines lt 2 lw 1.8 title "9 mph"
set ylabel "crosslevel, mm (left above right)"
set yrange [-30:140]
unset key
set xlabel "distance, ft (synthetic track, typical sensors, corners of 1 Hz)"
plot ARG1 using "x_ft":(on(80, column("crosslevel_true"))) with lines lc rgb light dt solid lw 8 title "truth", \
     ARG1 using "x_ft":(on(80, column("crosslevel_mm"))) with lines lt 1 lw 1.8 title "80 mph", \
     ARG1 using "x_ft":(on(9, column("crosslevel_mm"))) with lines lt 2 lw 1.8 title "9 mph"
unset multiplot
