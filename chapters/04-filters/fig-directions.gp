load "style.gp"
set output ARG2
set terminal pngcairo size 1200,760
set multiplot layout 2,1
set lmargin 10
set rmargin 24
set key outside right center nobox
set xrange [2000:2400]
set ylabel "62-ft chord, mm"
set title "four runs over the true rail: they hide each other; how far they differ is below" font ",13" offset 0,-0.4
run(v, y) = (column("run") == v ? y : NaN)
plot ARG1 using "x_ft":(run(9, column("truth_mm"))) with lines lc rgb light lw 7 dt solid title "true rail", \
     ARG1 using "x_ft":(run(80, column("profile_mm"))) with lines lt 1 lw 1.6 title "80 mph forwards", \
     ARG1 using "x_ft":(run(-80, column("profile_mm"))) with lines lt 2 lw 1.6 title "80 mph backwards", \
     ARG1 using "x_ft":(run(9, column("profile_mm"))) with lines lt 3 lw 1.6 title "9 mph forwards", \
     ARG1 using "x_ft":(run(-9, column("profile_mm"))) with lines lt 4 lw 1.6 title "9 mph backwards"
set title "each run less the true rail, enlarged" font ",13" offset 0,-0.4
set ylabel "error, mm"
set xlabel "distance, ft (synthetic track, ideal sensors, corners of 1 Hz)"
unset key
plot ARG1 using "x_ft":(run(80, column("error_mm"))) with lines lt 1 lw 1.6, \
     ARG1 using "x_ft":(run(-80, column("error_mm"))) with lines lt 2 lw 1.6, \
     ARG1 using "x_ft":(run(9, column("error_mm"))) with lines lt 3 lw 1.6, \
     ARG1 using "x_ft":(run(-9, column("error_mm"))) with lines lt 4 lw 1.6
unset multiplot
