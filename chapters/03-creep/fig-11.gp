# alt: Two panels of the fraction of the friction limit against X, with the points of four tests. Left, with Hertz's area, the tests lie apart; right, with the measured area, they lie about the theory's curve, which rises and levels off at one near X of one half. Vermeulen and Johnson's curve runs just above it.
load "style.gp"
set output ARG2
set terminal pngcairo size 1100,380 font "DejaVu Sans,13" enhanced background rgb "white"
set multiplot layout 1,2 margins 0.065,0.985,0.15,0.79 spacing 0.06
set xlabel "X = G a b ξ/µ_c N, a and b semi-axes"
set x2label "the same with full axes" offset 0,-0.4
set xrange [-0.05:1.2]
set x2range [-0.2:4.8]
set x2tics 0.8
set border 7
set yrange [0:1.15]
unset key
set label 11 "full theory" at 0.66, 0.86
set arrow 11 from 0.65,0.87 to 0.44,0.985 nohead lw 1
set label 12 "Vermeulen-\nJohnson" at -0.03,0.93 tc rgb "#606060"
set arrow 12 from 0.1,0.83 to 0.175,0.70 nohead lw 1 lc rgb "#606060"
loads = "500 1000 1500 2500"
set label 10 "synthetic points, not the paper's:" at 0.62, 0.62 tc rgb "#BE5400"
do for [k=1:4] { set label k word(loads, k)." lbf" at 0.72, 0.62-0.11*k point lt k+1 offset 1.5,0 }
array column_of[2]
column_of[1] = "x_hertz"
column_of[2] = "x_measured"
array title_of[2]
title_of[1] = "{/:Bold Hertz's area}"
title_of[2] = "{/:Bold measured area}"
do for [p=1:2] {
  if (p == 1) { set ylabel "f = µ/µ_c" } else { unset ylabel }
  set label 13 title_of[p] at 1.18,0.15 right
  plot for [k=1:4] ARG3 using (column("test") == word(loads, k) + 0 ? column(column_of[p]) : NaN):"f" with points lt k+1 ps 0.8, \
       ARG1 using "x":"full" with lines lt 1, ARG1 using "x":"vermeulen_johnson" with lines lt 8
}
unset multiplot
