# alt: Curvature falls from 0 along a spiral to minus 4 degrees per hundred feet, stays there and returns. Crosslevel rises to 100 mm and returns. At 9 and at 80 mph both lie on the true values, as two panels of errors show.
load "style.gp"
set terminal pngcairo size 740,520 font "DejaVu Sans,11"
set output ARG2
unset key
set multiplot
set xrange [3700:5900]
set lmargin 10
set rmargin 12
on(v, y) = (column("mph") == v ? y : NaN)
top(i) = 0.985 - 0.226 * i
set tmargin at screen top(0)
set bmargin at screen top(0) - 0.19
set format x ""
set ylabel "curvature,\ndeg per 100 ft"
set yrange [-5:0.8]
set ytics 2
set label 4 "9 mph" at graph 1.01,0.62 font ",11" textcolor rgb blue
set label 5 "80 mph" at graph 1.01,0.38 font ",11" textcolor rgb "#A84300"
set label 1 "true" at graph 1.01,0.86 font ",11" textcolor rgb grey
plot ARG1 using "x_ft":(on(80, column("curvature_true"))) with lines lc rgb light dt solid lw 6, \
     ARG1 using "x_ft":(on(80, column("curvature_deg_per_100ft"))) with lines lt 3 lw 1.6, \
     ARG1 using "x_ft":(on(9, column("curvature_deg_per_100ft"))) with lines lt 2 lw 1.6
set tmargin at screen top(1)
set bmargin at screen top(1) - 0.19
unset label 1
unset label 4
unset label 5
set ylabel "its error,\ndeg per 100 ft"
set yrange [-0.2:0.2]
set ytics 0.1
set label 2 "9 mph" at graph 1.01,0.75 font ",11" textcolor rgb blue
set label 3 "80 mph" at graph 1.01,0.50 font ",11" textcolor rgb "#A84300"
plot ARG1 using "x_ft":(on(9, column("curvature_deg_per_100ft") - column("curvature_true"))) with lines lt 2 lw 1.4 dt 1, \
     ARG1 using "x_ft":(on(80, column("curvature_deg_per_100ft") - column("curvature_true"))) with lines lt 3 lw 1.8 dt 1
set tmargin at screen top(2)
set bmargin at screen top(2) - 0.19
unset label 2
unset label 3
set ylabel "crosslevel, mm"
set yrange [-30:130]
set ytics 50
plot ARG1 using "x_ft":(on(80, column("crosslevel_true"))) with lines lc rgb light dt solid lw 6, \
     ARG1 using "x_ft":(on(80, column("crosslevel_mm"))) with lines lt 3 lw 1.6, \
     ARG1 using "x_ft":(on(9, column("crosslevel_mm"))) with lines lt 2 lw 1.6
set tmargin at screen top(3)
set bmargin at screen top(3) - 0.19
set format x "%g"
set ylabel "its error, mm"
set yrange [-8:8]
set ytics 4
set xlabel "distance, ft"
plot ARG1 using "x_ft":(on(9, column("crosslevel_mm") - column("crosslevel_true"))) with lines lt 2 lw 1.4 dt 1, \
     ARG1 using "x_ft":(on(80, column("crosslevel_mm") - column("crosslevel_true"))) with lines lt 3 lw 1.8 dt 1
unset multiplot
