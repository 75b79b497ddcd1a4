# ARG1: constraint functions; ARG3, ARG4: wheel and rail; ARG5: lines that join points that touch; ARG6: two-point contact.
load "style.gp"
set terminal pngcairo size 1000,550 font "DejaVu Sans,14" enhanced background rgb "white"
set output ARG2
set multiplot
set xrange [0:0.025]
set xtics 0.005
set xlabel "x_w / a" offset 0,0.5
set key left top reverse Left

set lmargin at screen 0.105
set rmargin at screen 0.475
set tmargin at screen 0.97
set bmargin at screen 0.61
set ylabel "rolling radius, in" offset 0.5
plot ARG1 using "x_over_a":"r_L_in" with lines lt 1 title "r_L", \
     ARG1 using "x_over_a":"r_R_in" with lines lt 2 title "r_R"

set lmargin at screen 0.595
set rmargin at screen 0.965
set ylabel "contact angle, rad" offset 0.5
plot ARG1 using "x_over_a":"delta_L_rad" with lines lt 1 title "δ_L", \
     ARG1 using "x_over_a":"delta_R_rad" with lines lt 2 title "δ_R", \
     ARG1 using "x_over_a":"D_rad" with lines lt 3 title "D"

set lmargin at screen 0.105
set rmargin at screen 0.40
set tmargin at screen 0.47
set bmargin at screen 0.13
set xtics 0.01
set ytics 0.01
set ylabel "R; φ_w, rad" offset 0.5
set yrange [0:*]
plot ARG1 using "x_over_a":"R" with lines lt 1 title "R", \
     ARG1 using "x_over_a":"phi_rad" with lines lt 2 title "φ_w"

set lmargin at screen 0.50
set rmargin at screen 0.965
set xrange [-2.2:3.3]
set yrange [-1.1:1.2]
set xtics 1
set ytics 0.5
set xlabel "inwards from the middle of the rail's head, in"
set ylabel "height, in" offset 1
unset key
set label 1 "wheel, lifted" at -2.1,1.08
set label 2 "rail" at -0.5,-0.2 tc rgb blue
set label 3 "two-point contact" at -0.5,-0.5 tc rgb red
set label 4 "points that touch" at -0.5,-0.8 tc rgb sky
plot ARG5 using 1:2 with lines lc rgb sky lw 1, \
     ARG6 using 1:2 with lines lc rgb red lw 2.4 dt solid, \
     ARG3 using 1:2 with lines lt 1, \
     ARG4 using 1:2 with lines lt 2 dt solid
unset multiplot
