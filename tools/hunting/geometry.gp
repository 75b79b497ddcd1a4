load "style.gp"
set terminal pngcairo size 1000,1000
set output ARG2
set multiplot layout 3,1
set lmargin 13
set key left top reverse Left
set ylabel "rolling radius, mm"
plot ARG1 using "x_mm":"r_L_mm" with lines lt 1 title "r_L", \
     ARG1 using "x_mm":"r_R_mm" with lines lt 2 title "r_R"
set ylabel "contact angle, rad"
plot ARG1 using "x_mm":"delta_L_rad" with lines lt 1 title "δ_L", \
     ARG1 using "x_mm":"delta_R_rad" with lines lt 2 title "δ_R"
set ylabel "rad, or none"
set xlabel "lateral displacement, mm"
plot ARG1 using "x_mm":"R" with lines lt 1 title "R = (r_L - r_R)/2a", \
     ARG1 using "x_mm":"phi_rad" with lines lt 2 title "φ_w"
unset multiplot
