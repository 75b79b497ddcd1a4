load "style.gp"
set terminal pngcairo size 1300,450
set output ARG2
set xlabel "distance, ft"
set ylabel "profile, in (down)"
set yrange [0.35:-0.3]
set xrange [0:390]
set xtics 39
set key top right horizontal
set label "synthetic" at graph 0.01, graph 0.06 tc rgb red front
plot ARG1 using 1:2 with lines lt 1 lw 1.6 title "rectified sine + random (class 3)", \
     ARG1 using 1:3 with lines lt 3 lw 1.6 title "rectified sine alone"
