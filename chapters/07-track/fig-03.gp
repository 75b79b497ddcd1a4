# alt: Stiffness near a joint over that of unjointed rail, two panels. At a hinge it rises from one
# alt: half to one, dips slightly and returns; the formula rises more slowly. At a free joint it
# alt: rises from a quarter, and the formula follows it closely.
load "style.gp"
set output ARG2
set terminal pngcairo size 1300,540
set multiplot layout 1,2
set xlabel "normalised distance from the joint, βX"
set ylabel "K_j / K_r"
set xrange [0:3]
set yrange [0:1.1]
set key bottom right
set rmargin 2
set label 1 "hinge: shear, no bending" at graph 0.5, graph 0.96 center
plot ARG1 using "beta_x":"hinge" with lines lt 1 title "exact", \
     ARG1 using "beta_x":"eq8_hinge" with lines lt 3 title "equation (8), δ = 0.5", \
     ARG3 using "beta_x":"hinge" with points ls other title "beam elements"
set label 1 "free joint"
unset ylabel
plot ARG1 using "beta_x":"free" with lines lt 1 title "exact", \
     ARG1 using "beta_x":"eq8_free" with lines lt 3 title "equation (8), δ = 0.25", \
     ARG3 using "beta_x":"free" with points ls other title "beam elements"
unset multiplot
