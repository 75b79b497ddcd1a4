# ARG1: constraint functions; ARG3, ARG4: wheel and rail; ARG5: lines that join points that touch; ARG6: two-point contact.
# alt: Three graphs of rolling radii, contact angles, and R and roll against displacement, nearly straight and then bending up where
# alt: the flange is met; below them the outlines of a wheel and its rail, joined by lines between the points that touch.
load "style.gp"
set terminal pngcairo size 740,520 font "DejaVu Sans,12" enhanced background rgb "white"
set output ARG2
W = 740.0; H = 520.0
stats ARG1 using "r_L_in" name "L" nooutput
stats ARG1 using (D_at_end = column("D_rad")) nooutput
set multiplot
unset key
set xrange [0:0.025]
set xtics 0.01
set xlabel "x_w / a" offset 0,0.5

set tmargin at screen (H - 30)/H
set bmargin at screen (H - 215)/H
set lmargin at screen 60/W
set rmargin at screen 236/W
set yrange [16.35:17.7]
set ytics 16.4,0.4
set label 1 "rolling radius, in" at graph 0,1.08 left
set label 2 "r_L" at 0.0245,L_max right offset 0,-1.2
set label 3 "r_R" at 0.0245,16.5 right offset 0,0.8 tc rgb blue
plot ARG1 using "x_over_a":"r_L_in" with lines lt 1, \
     ARG1 using "x_over_a":"r_R_in" with lines lt 2

set lmargin at screen 298/W
set rmargin at screen 474/W
set ytics 0.4
set yrange [0:1.3]
set label 1 "contact angle, rad"
set label 2 "δ_L" at 0.008,0.6 right offset 0,0
set label 3 "δ_R" at 0.0195,0.135 right offset 0,0 tc rgb blue
set label 4 "D" at 0.0245,D_at_end + 0.15 right offset 0,0 tc rgb red
plot ARG1 using "x_over_a":"delta_L_rad" with lines lt 1, \
     ARG1 using "x_over_a":"delta_R_rad" with lines lt 2, \
     ARG1 using "x_over_a":"D_rad" with lines lt 3
unset label

set lmargin at screen 536/W
set rmargin at screen 714/W
set ytics 0.01
set yrange [0:0.024]
set label 1 "R, and roll φ_w, rad" at graph 0,1.08 left
set label 2 "R" at 0.0245,0.0222 right
set label 3 "φ_w" at 0.0245,0.011 right tc rgb blue
plot ARG1 using "x_over_a":"R" with lines lt 1, \
     ARG1 using "x_over_a":"phi_rad" with lines lt 2
unset label

# To scale.
set lmargin at screen 60/W
set rmargin at screen 714/W
set tmargin at screen (H - 274)/H
set bmargin at screen 60/H
set xrange [-2.2:3.3]
set yrange [-0.78:1.1]
set xtics 1
set ytics 0.5
set xlabel "inches inwards from the middle of the rail's head" offset 0,0.6
set label 2 "left wheel, lifted" at -2.1,1.05
set label 3 "rail" at -1.2,-0.25 tc rgb blue
set label 4 "lines join the points that touch" at -0.9,-0.42 tc rgb sky
set label 5 "thick: two points touch at once" at -0.9,-0.6 tc rgb red
set label 6 "flange" at 2.75,-0.62 center
plot ARG5 using 1:2 with lines lc rgb sky lw 1, \
     ARG6 using 1:2 with lines lc rgb red lw 2.4 dt solid, \
     ARG3 using 1:2 with lines lt 1, \
     ARG4 using 1:2 with lines lt 2 dt solid
unset multiplot
