load "style.gp"
set output ARG2
set title "stability by Floquet multipliers, every tenth point"
set tmargin 5
set xlabel "speed, m/s"
set ylabel "largest wheelset amplitude, mm"
set yrange [0:*]
set offsets graph 0.05, graph 0.05, 0, 0
set key outside top center horizontal maxrows 1
plot ARG1 using 1:2 with lines lt 8 title "limit cycles", \
     ARG1 using 1:9 with points pt 7 lc rgb black title "stable", \
     ARG1 using 1:10 with points pt 6 lc rgb red title "unstable", \
     ARG1 using 1:11 with points pt 2 lc rgb red title "not found"
