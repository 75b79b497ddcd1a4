load "style.gp"
set terminal pngcairo size 1000,1250
set output ARG2
set multiplot
set lmargin at screen 0.12
set rmargin at screen 0.955
set xrange [0:0.025]
set format x ""
set key left top reverse Left

set tmargin at screen 0.96
set bmargin at screen 0.79
set ylabel "rolling radius, in"
set label "profiles reconstructed" at screen 0.95,0.975 right tc rgb red
plot ARG1 using "x_over_a":"r_L_in" with lines lt 1 title "r_L", \
     ARG1 using "x_over_a":"r_R_in" with lines lt 2 title "r_R"
unset label

set tmargin at screen 0.77
set bmargin at screen 0.60
set ylabel "contact angle, rad"
plot ARG1 using "x_over_a":"delta_L_rad" with lines lt 1 title "δ_L", \
     ARG1 using "x_over_a":"delta_R_rad" with lines lt 2 title "δ_R", \
     ARG1 using "x_over_a":"D_rad" with lines lt 3 title "D = (δ_L - δ_R)/2"

set tmargin at screen 0.58
set bmargin at screen 0.41
set format x "%g"
set xlabel "x_w / a" offset 0,0.4
set ylabel "rad, or none"
set yrange [0:*]
plot ARG1 using "x_over_a":"R" with lines lt 1 title "R = (r_L - r_R)/2a", \
     ARG1 using "x_over_a":"phi_rad" with lines lt 2 title "φ_w, rad"

set tmargin at screen 0.34
set bmargin at screen 0.06
set xrange [-2.2:3.3]
set yrange [-1.1:1.2]
set xlabel "from the middle of the rail's head towards the track's centre, in" offset 0,0.4
set ylabel "height, in"
set key left bottom reverse Left
plot ARG5 using 1:2 with lines lc rgb sky lw 1 title "points that touch", \
     ARG6 using 1:2 with lines lc rgb red lw 2.4 dt solid title "two-point contact", \
     ARG3 using 1:2 with lines lt 1 title "wheel, lifted", \
     ARG4 using 1:2 with lines lt 2 dt solid title "rail"
unset multiplot
