load "style.gp"
set terminal pngcairo size 1000,520
set output ARG2
set datafile missing "nan"
set xlabel "distance from the joint, m"
set ylabel "height / B"
set xrange [-12:12]
set yrange [-0.12:1.3]
set key top center horizontal
set arrow from -0.15,0 to -0.15,0.949 heads filled size 0.25,20 lc rgb blue lw 2
set arrow from 0.15,0 to 0.15,0.601 heads filled size 0.25,20 lc rgb red lw 2
set label "9.5-m MCO" right at -0.5,0.8 textcolor rgb blue
set label "19-m MCO" left at 0.5,0.5 textcolor rgb red
set label "joint" center at 0,-0.06
plot ARG1 using "x_m":"z_over_B" with lines lt 1 title "rectified sine, 11.9-m rail", \
     ARG3 using "x_m":"short" with linespoints lt 2 title "9.5-m chord", \
     ARG3 using "x_m":"long" with linespoints lt 3 title "19-m chord"
