load "style.gp"
set output ARG2
set terminal pngcairo size 900,270
set xlabel "creep"
set ylabel "µ = T/N"
set xrange [0:0.02]
set yrange [0:0.7]
set ytics 0.2
set key bottom right
set label "synthetic points, not the paper's" at graph 0.03, 0.95 tc rgb "#D55E00"
plot ARG3 using 1:2 with points lt 2 title "synthetic points", \
     ARG1 using 1:2 with lines lt 1 title "average curve"
