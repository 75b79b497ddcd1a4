# alt: Error against speed on logarithmic axes. With typical sensors, alignment and profile fall from some hundreds of millimetres at 0.5 mph to below 1 mm at 120 mph; crosslevel stays near 1.6 mm and gage at 0.05 mm.
# alt: Curvature falls from 0.14 degrees per hundred feet at 0.5 mph to 0.025 above 15 mph. With perfect sensors the errors are smaller and those of crosslevel fall towards low speed.
load "style.gp"
set terminal pngcairo size 740,370 font "DejaVu Sans,11"
set output ARG2
unset key
set multiplot layout 1,2
set logscale xy
set xlabel "speed, mph"
set xrange [0.45:130]
set xtics (0.5, 1, 2, 5, 10, 20, 50, 120)
set ylabel "RMS error, mm"
set yrange [0.008:1000]
set format y "10^{%T}"
on(which, y) = (strcol("sensors") eq which && y > 1e-9 ? y : NaN)
set label 1 "alignment" at 0.8,600 font ",11"
set label 2 "profile" at 0.53,4 font ",11" textcolor rgb blue
set label 3 "crosslevel" at 18,3.4 font ",11" textcolor rgb "#A84300"
set label 4 "gage" at 0.55,0.1 font ",11" textcolor rgb "#00694B"
plot ARG1 using 1:(on("typical", column("alignment_mm"))) with lines lt 1, \
     ARG1 using 1:(on("typical", column("profile_mm"))) with lines lt 2 dt 1, \
     ARG1 using 1:(on("typical", column("crosslevel_mm"))) with lines lt 3 dt 1, \
     ARG1 using 1:(on("typical", column("gage_mm"))) with lines lt 4 dt 1, \
     ARG1 using 1:(on("ideal", column("alignment_mm"))) with points lt 1, \
     ARG1 using 1:(on("ideal", column("profile_mm"))) with points lt 2, \
     ARG1 using 1:(on("ideal", column("crosslevel_mm"))) with points lt 3
unset label 1; unset label 2; unset label 3; unset label 4
set ylabel "RMS error, deg per 100 ft"
set yrange [0.01:0.2]
set ytics (0.01, 0.02, 0.05, 0.1, 0.2)
set format y "%g"
set label 1 "curvature" at 1.6,0.1 font ",11" textcolor rgb "#8A3A70"
plot ARG1 using 1:(on("typical", column("curvature_deg_per_100ft"))) with lines lt 5 dt 1, \
     ARG1 using 1:(on("ideal", column("curvature_deg_per_100ft"))) with points lt 5
unset multiplot
