load "style.gp"
set output ARG2
set terminal pngcairo size 900,410
set xlabel "G a b ξ/(µ_c N), a and b semi-axes"
set x2label "the same with full axes"
set ylabel "µ/µ_c"
set xrange [-0.05:1.2]
set x2range [-0.2:4.8]
set x2tics 0.4
set border 7
set tmargin 4.5
set yrange [0:1.25]
set key bottom right maxrows 4
set label "synthetic points, not the paper's" at graph 0.03, 0.95 tc rgb "#D55E00"
loads = "500 1000 1500 2500"
plot for [k=1:4] ARG3 using (column("test") == word(loads, k) + 0 ? column("x") : NaN):"f" with points lt k+1 title word(loads, k)." lbf", \
     ARG1 using 1:2 with lines lt 1 title "full theory", \
     ARG1 using 1:3 with lines lt 7 title "FASTSIM", \
     ARG1 using 1:4 with lines lt 8 title "Vermeulen-Johnson"
