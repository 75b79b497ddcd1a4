load "style.gp"
set terminal pngcairo size 1000,800
set output ARG2
set multiplot layout 2,1
set lmargin 10
set autoscale xfix
unset key
set ylabel "wheel/rail force, kN"
set yrange [0:*]
plot ARG1 using "time_ms":"force_kN" with lines lt 1
set key above horizontal maxrows 1
set xlabel "time after distance 0, ms"
set ylabel "displacement, mm (down)"
set yrange [*:*] reverse
plot ARG1 using "time_ms":"surface_mm" with lines lt 8 title "surface", \
     ARG1 using "time_ms":"wheel_mm" with lines lt 1 title "wheel", \
     ARG1 using "time_ms":"rail_mm" with lines lt 2 title "rail", \
     ARG1 using "time_ms":"bed_mm" with lines lt 3 title "bed"
unset multiplot
