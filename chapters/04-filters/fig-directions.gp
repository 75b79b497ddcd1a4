# alt: Above, the true profile of 400 feet of rail between minus 20 and 15 mm. Below, the error of four runs: within 0.02 mm at 80 mph, and at 9 mph up to some 0.2 mm, of opposite sign forwards and backwards.
load "style.gp"
set terminal pngcairo size 740,390 font "DejaVu Sans,11"
set output ARG2
unset key
set multiplot
set lmargin 10
set rmargin 16
set xrange [2000:2400]
set ylabel "true profile, mm"
run(v, y) = (column("run") == v ? y : NaN)
set tmargin at screen 0.97
set bmargin at screen 0.66
set format x ""
plot ARG1 using "x_ft":(run(9, column("truth_mm"))) with lines lc rgb grey lw 2.4 dt solid
set tmargin at screen 0.60
set bmargin at screen 0.16
set format x "%g"
set ylabel "error of the run, mm"
set xlabel "distance, ft"
set label 1 "9 mph forwards" at graph 1.01,0.82 font ",10" textcolor rgb blue
set label 2 "9 mph backwards" at graph 1.01,0.18 font ",10" textcolor rgb "#00694B"
set label 3 "80 mph,\nboth ways" at graph 1.01,0.54 font ",10" textcolor rgb "#A84300"
plot ARG1 using "x_ft":(run(9, column("error_mm"))) with lines lt 2 dt 1 lw 1.8, \
     ARG1 using "x_ft":(run(-9, column("error_mm"))) with lines lt 4 dt 2 lw 1.8, \
     ARG1 using "x_ft":(run(80, column("error_mm"))) with lines lt 3 dt 1 lw 1.6, \
     ARG1 using "x_ft":(run(-80, column("error_mm"))) with lines lt 3 dt 2 lw 1.6
unset multiplot
