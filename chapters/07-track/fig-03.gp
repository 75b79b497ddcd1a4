# alt: Stiffness near a joint over that of unjointed rail, two panels. At a hinge it rises from one
# alt: half to one, dips slightly and returns; the formula rises more slowly. At a free joint it
# alt: rises from a quarter, and the formula follows it closely.
load "style.gp"
set output ARG2
set terminal pngcairo size 1100,430 font "DejaVu Sans,13" enhanced background rgb "white"
set multiplot layout 1,2
set xlabel "distance from the joint, βX"
set ylabel "stiffness ratio K_j/K_r"
set xrange [0:3]
set yrange [0:1.12]
unset key
set rmargin 2
set label 1 "pinned joint: carries shear, no bending" at graph 0.97, graph 0.08 right
set label 2 "exact" at 2.2,0.9 center
set label 3 "formula (8), δ = 0.5" at 2.2,1.06 center tc rgb "#BE5400"
set label 4 "squares: finite elements" at graph 0.97, graph 0.2 right tc rgb "#007A5A"
plot ARG1 using "beta_x":"hinge" with lines lt 1, \
     ARG1 using "beta_x":"eq8_hinge" with lines lt 3, \
     ARG3 using "beta_x":"hinge" with points ls other
set label 1 "free joint: carries neither"
set label 3 "formula (8), δ = 0.25"
unset ylabel
plot ARG1 using "beta_x":"free" with lines lt 1, \
     ARG1 using "beta_x":"eq8_free" with lines lt 3, \
     ARG3 using "beta_x":"free" with points ls other
unset multiplot
