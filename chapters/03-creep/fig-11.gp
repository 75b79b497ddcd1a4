# alt: Two panels of the fraction of the friction limit against X, with the points of four tests. Left, with Hertz's area, the tests lie apart; right, with the measured area, they lie about the theory's curve, which rises and levels off at one near X of one half. Vermeulen and Johnson's curve runs just above it.
load "style.gp"
set output ARG2
set terminal pngcairo size 1100,400 font "DejaVu Sans,13" enhanced background rgb "white"
set multiplot layout 1,2 margins 0.085,0.98,0.175,0.80 spacing 0.08
set xlabel "X = G a b ξ / (µ_c N), a and b semi-axes" offset 0,0.3
set x2label "the same with full axes" offset 0,-0.5
set xrange [-0.05:1.2]
set x2range [-0.2:4.8]
set xtics 0,0.2,1.2
set x2tics 0,0.8,4.8
set border 7
set yrange [0:1.15]
unset key
set label 11 "full theory" at 0.56, 0.89
set arrow 11 from 0.55,0.89 to 0.36,0.945 nohead lw 1
set label 12 "Vermeulen-\nJohnson" at 0.56,0.76 tc rgb "#606060"
set arrow 12 from 0.55,0.75 to 0.215,0.775 nohead lw 1 lc rgb "#606060"
loads = "500 1000 1500 2500"
set label 10 "synthetic points:" at 0.56, 0.55 tc rgb "#BE5400"
do for [k=1:4] { set label k word(loads, k)." lbf" at 0.60, 0.545-0.11*k point lt k+1 offset 1.5,0 }
array column_of[2]
column_of[1] = "x_hertz"
column_of[2] = "x_measured"
array title_of[2]
title_of[1] = "{/:Bold Hertz's area}"
title_of[2] = "{/:Bold measured area}"
do for [p=1:2] {
  if (p == 1) { set ylabel "f = µ/µ_c" } else { unset ylabel }
  set label 13 title_of[p] at graph 0.5,1.28 center
  plot for [k=1:4] ARG3 using (column("test") == word(loads, k) + 0 ? column(column_of[p]) : NaN):"f" with points lt k+1 ps 0.8, \
       ARG1 using "x":"full" with lines lt 1, ARG1 using "x":"vermeulen_johnson" with lines lt 8
}
unset multiplot
