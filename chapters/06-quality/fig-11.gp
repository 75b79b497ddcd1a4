# alt: Two pairs of curves against tonnage. The standard deviation of segment B grows faster than that of A; the number n falls below 3 for B at 2.1 units of tonnage and for A at four times as many.
load "style.gp"
set terminal pngcairo size 740,370 font "DejaVu Sans,11"
set output ARG2
unset key
set multiplot
set lmargin 9
set rmargin 16
set xrange [0:10]
set tmargin at screen 0.97
set bmargin at screen 0.56
set format x ""
set ylabel "standard deviation s"
set yrange [0:0.6]
set label 1 "B: surfaced only" at graph 1.01,0.78 font ",10" textcolor rgb "#A84300"
set label 2 "A: ties renewed" at graph 1.01,0.45 font ",10"
plot ARG1 using "tonnage":"s_A" with lines lt 1, ARG1 using "tonnage":"s_B" with lines lt 3 dt 1
set tmargin at screen 0.50
set bmargin at screen 0.165
set format x "%g"
set ylabel "n = T_2/s"
set xlabel "tonnage, arbitrary units"
set yrange [0:6]
set label 1 "B" at graph 1.01,0.28
set label 2 "A" at graph 1.01,0.47
set label 3 "end of basic\nmaintenance" at graph 1.01,0.62 font ",10"
set label 3 at graph 1.03,0.40 font ",10"
set label 3 "n = 3" at 0.15,2.6 font ",10"
set arrow from 0,3 to 10,3 nohead ls guide
plot ARG1 using "tonnage":"n_A" with lines lt 1, ARG1 using "tonnage":"n_B" with lines lt 3 dt 1
unset multiplot
