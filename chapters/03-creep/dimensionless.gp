# alt: The fraction of the friction limit against X. Points of four tests about the theory's curve, which rises and levels off at one near X of one half; Vermeulen and Johnson's curve runs just above it.
load "style.gp"
set output ARG2
set terminal pngcairo size 740,400 font "DejaVu Sans,12" enhanced background rgb "white"
set xlabel "X = G a b ξ/µ_c N, a and b semi-axes"
set x2label "the same with full axes"
set ylabel "f = µ/µ_c"
set xrange [-0.05:1.2]
set x2range [-0.2:4.8]
set x2tics 0.8
set border 7
set tmargin 4.5
set yrange [0:1.25]
unset key
set label "synthetic points, not the paper's:" at 0.62, 0.62 tc rgb "#BE5400"
set label "full theory" at 0.66, 0.86
set arrow from 0.65,0.87 to 0.44,0.985 nohead lw 1
set label "Vermeulen-\nJohnson" at -0.03,0.93 tc rgb "#606060"
set arrow from 0.1,0.83 to 0.175,0.70 nohead lw 1 lc rgb "#606060"
loads = "500 1000 1500 2500"
do for [k=1:4] { set label word(loads, k)." lbf" at 0.72, 0.62-0.1*k point lt k+1 offset 1.5,0 }
plot for [k=1:4] ARG3 using (column("test") == word(loads, k) + 0 ? column("x") : NaN):"f" with points lt k+1 ps 0.8, \
     ARG1 using "x":"full" with lines lt 1, ARG1 using "x":"vermeulen_johnson" with lines lt 8
