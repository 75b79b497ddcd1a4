# alt: Two arches of a rail with a joint between. The short chord spans from near crest to near
# alt: crest and lies 0.95 b above the joint, the long one reaches beyond the crests and lies 0.60 b
# alt: above it.
load "style.gp"
set terminal pngcairo size 1000,430
set output ARG2
set datafile missing "nan"
set xlabel "distance from the joint, m"
set ylabel "height / b"
set xrange [-12:12]
set yrange [-0.12:1.35]
set key top center horizontal maxrows 1
set label "joint" center at 0,-0.06
set style arrow 1 heads filled size 0.25,20 lc rgb black lw 2
plot ARG1 using "x_m":"z_over_B" with lines lt 1 title "rectified sine", \
     ARG3 using "x_m":"short" with linespoints lt 2 title "9.5-m chord", \
     ARG3 using "x_m":"long" with linespoints lt 3 title "19-m chord", \
     ARG4 using "x_m":(0):(0):"z_over_B" with vectors arrowstyle 1, \
     ARG4 using ($1 > 0 ? 0.4 : NaN):($2 + 0.06):(sprintf("%.2f b", $2)) with labels left textcolor rgb red, \
     ARG4 using ($1 < 0 ? -0.4 : NaN):($2 - 0.06):(sprintf("%.2f b", $2)) with labels right textcolor rgb blue
