# alt: Five panels. Four show, for one load each, points with error bars that rise with the creep and level off, and a curve through them; the last shows the four curves together, the one at 500 lbf highest and the one at 2500 lbf lowest at large creep.
load "style.gp"
set output ARG2
set terminal pngcairo size 1100,270 font "DejaVu Sans,13" enhanced background rgb "white"
unset key
set multiplot
set xrange [-0.001:0.021]
set yrange [0:0.65]
set xtics 0,0.01,0.01
set xlabel "creep ξ" offset 0,0.4
set bmargin at screen 0.22
set tmargin at screen 0.88
do for [k=1:5] {
  set lmargin at screen 0.065+0.185*(k-1)
  set rmargin at screen 0.065+0.185*(k-1)+0.165
  if (k == 1) { set ylabel "µ" offset 1.5,0 } else { set format y ""; unset ylabel }
  load_lbf = k < 5 ? word("500 1000 1500 2500", k) : "all"
  set label 1 (k < 5 ? load_lbf." lbf" : "all four") at graph 0.05, 0.93
  if (k == 1) { set label 2 "synthetic points, not the paper's" at graph 0.02, 1.09 tc rgb "#BE5400" } else { unset label 2 }
  if (k < 5) {
    plot ARG3 using (column("load_lbf") == load_lbf + 0 ? column("creep") : NaN):"mu":"creep_error":"mu_error" with xyerrorbars lt k+1 dt solid lw 1 ps 0.6, \
         ARG1 using "creep":"mu_".load_lbf with lines lt 1 lw 2
  } else {
    plot for [n=1:4] ARG1 using 1:n+1 with lines lt n+1
  }
}
unset multiplot
