load "style.gp"
set output ARG2
set terminal pngcairo size 900,370
set xlabel "normal load, lbf"
set ylabel "friction coefficient µ"
set xrange [400:2700]
set yrange [0:0.85]
set key top right maxrows 2
set label "synthetic: lines at one wear (area 1.5 times Hertz's), points of the four tests" at graph 0, 1.04 tc rgb "#D55E00"
creep = "0.0005 0.001 0.002 0.004"
plot for [k=2:5] ARG1 using 1:k with lines lt k-1 title "creep ".word(creep, k-1), \
     ARG1 using 1:6 with lines lt 5 title "largest", \
     for [k=2:6] ARG3 using 1:k with points lt k-1
