load "style.gp"
set output ARG2
set tmargin 5
set xlabel "speed, m/s"
set ylabel "largest wheelset amplitude, mm"
set yrange [0:*]
set offsets graph 0.05, graph 0.05, 0, 0
set key outside top center horizontal maxrows 2 title "stability by Floquet multipliers"
plot for [b=1:9] ARG1 using ($1==b ? $2 : NaN):3 with lines lt 8 title (b==1 ? "limit cycles" : ""), \
     for [b=1:9] ARG1 using ($1==b ? $2 : NaN):11 with lines lw 4 dt solid lc rgb black title (b==1 ? "stable" : ""), \
     for [b=1:9] ARG1 using ($1==b ? $2 : NaN):12 with lines lw 2.5 dt (8,5) lc rgb red title (b==1 ? "unstable" : ""), \
     ARG3 using 2:(strcol(4) eq "fold" ? $3 : NaN) with points pt 7 lc rgb black title "fold", \
     ARG3 using 2:(strcol(4) eq "torus" ? $3 : NaN) with points pt 6 lc rgb black title "torus", \
     ARG3 using 2:(strcol(4) eq "symmetry breaking" ? $3 : NaN) with points pt 8 lc rgb black title "symmetry breaking", \
     ARG3 using 2:(strcol(4) eq "period doubling" ? $3 : NaN) with points pt 4 lc rgb black title "period doubling"
