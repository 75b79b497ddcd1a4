load "style.gp"
set output ARG2
set terminal pngcairo size 1300,620
set multiplot layout 1,2
set logscale xy
set xlabel "speed, mph"
set xrange [0.45:130]
set xtics (0.5, 1, 2, 5, 10, 20, 50, 100)
set ylabel "RMS error, mm"
set yrange [0.008:1000]
set format y "10^{%T}"
set key top right
on(which, y) = (strcol("sensors") eq which && y > 1e-9 ? y : NaN)
set title "line: typical sensors; points: perfect sensors (of gage: no error)" font ",12" offset 0,-0.6
plot ARG1 using 1:(on("typical", column("alignment_mm"))) with lines lt 1 title "alignment", \
     ARG1 using 1:(on("typical", column("profile_mm"))) with lines lt 2 title "profile", \
     ARG1 using 1:(on("typical", column("crosslevel_mm"))) with lines lt 3 title "crosslevel", \
     ARG1 using 1:(on("typical", column("gage_mm"))) with lines lt 4 title "gage", \
     ARG1 using 1:(on("ideal", column("alignment_mm"))) with points lt 1, \
     ARG1 using 1:(on("ideal", column("profile_mm"))) with points lt 2, \
     ARG1 using 1:(on("ideal", column("crosslevel_mm"))) with points lt 3
set ylabel "RMS error, deg per 100 ft"
set yrange [0.01:0.2]
set ytics (0.01, 0.02, 0.05, 0.1, 0.2)
set format y "%g"
set title "line: typical sensors, gyro debiased; points: perfect sensors" font ",12" offset 0,-0.6
plot ARG1 using 1:(on("typical", column("curvature_deg_per_100ft"))) with lines lt 5 title "curvature", \
     ARG1 using 1:(on("ideal", column("curvature_deg_per_100ft"))) with points lt 5
unset multiplot
