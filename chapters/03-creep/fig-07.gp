load "style.gp"
set output ARG2
set terminal pngcairo size 900,370
set xlabel "creep"
set ylabel "friction coefficient µ = T/N"
set xrange [0:0.02]
set yrange [0:0.7]
set key bottom right
set label "from synthetic points" at graph 0.03, 0.95 tc rgb "#D55E00"
plot for [k=2:5] ARG1 using 1:k with lines lt k-1 title word("500 1000 1500 2500", k-1)." lbf"
