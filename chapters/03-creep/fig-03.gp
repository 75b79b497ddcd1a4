# alt: Four panels, one for each load. In each, points with error bars rise with the creep and level off, and a curve runs through them. The error bars of the friction are largest at the smallest load.
load "style.gp"
set output ARG2
set terminal pngcairo size 1100,330 font "DejaVu Sans,13" enhanced background rgb "white"
unset key
set multiplot
set xrange [-0.001:0.021]
set yrange [0:0.65]
set xtics 0,0.01,0.02
set xlabel "creep ξ" offset 0,0.3
set bmargin at screen 0.19
set tmargin at screen 0.89
do for [k=1:4] {
  load_lbf = word("500 1000 1500 2500", k)
  set lmargin at screen 0.07+0.235*(k-1)
  set rmargin at screen 0.07+0.235*(k-1)+0.205
  if (k > 1) { set format y ""; unset ylabel } else { set ylabel "µ = T/N" }
  set label 1 load_lbf." lbf" at graph 0.05, 0.93
  if (k == 1) { set label 2 "synthetic points, not the paper's" at graph 0.05, 1.07 tc rgb "#BE5400" } else { unset label 2 }
  plot ARG3 using (column("load_lbf") == load_lbf + 0 ? column("creep") : NaN):"mu":"creep_error":"mu_error" with xyerrorbars lt k+1 dt solid lw 1 ps 0.6, \
       ARG1 using "creep":"mu_".load_lbf with lines lt 1 lw 2
}
unset multiplot
