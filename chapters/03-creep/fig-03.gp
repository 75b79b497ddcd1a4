# alt: Four small panels show, for one load each, points with error bars that rise with the creep and level off, and a curve through them. A large panel shows the four curves together: the one at 500 lbf ends highest, those at 1500 and 2500 lbf cross.
load "style.gp"
set output ARG2
set terminal pngcairo size 1100,390 font "DejaVu Sans,13" enhanced background rgb "white"
unset key
set multiplot
set xrange [-0.0006:0.012]
set yrange [0:0.65]
set xtics 0,0.004,0.012
set ytics 0.2
set label 2 "synthetic points, not the paper's" at screen 0.06,0.97 tc rgb "#BE5400"
do for [k=1:4] {
  col = (k-1) % 2
  row = (k-1) / 2
  set lmargin at screen 0.068+0.24*col
  set rmargin at screen 0.068+0.24*col+0.207
  set tmargin at screen 0.93-0.42*row
  set bmargin at screen 0.93-0.42*row-0.355
  if (col == 0) { set ylabel "friction µ" offset 0.6,0; set format y "%g" } else { set format y ""; unset ylabel }
  if (row == 1) { set xlabel "creep ξ" offset 0,0.4; set format x "%g" } else { set format x ""; unset xlabel }
  load_lbf = word("500 1000 1500 2500", k)
  set label 1 load_lbf." lbf" at graph 0.97, 0.1 right
  plot ARG3 using (column("load_lbf") == load_lbf + 0 ? column("creep") : NaN):"mu":"creep_error":"mu_error" with xyerrorbars lt k+1 dt solid lw 1 ps 0.7, \
       ARG1 using "creep":"mu_".load_lbf with lines lt 1 lw 2
  unset label 2
}
unset label 1
set lmargin at screen 0.61
set rmargin at screen 0.90
set tmargin at screen 0.93
set bmargin at screen 0.15
set ylabel "friction coefficient µ" offset 0.5,0
set format y "%g"
set xrange [0:0.02]
set xtics 0,0.005,0.02
set ytics 0.1
set yrange [0:0.6]
set xlabel "creep ξ"
do for [k=1:4] {
  load_lbf = word("500 1000 1500 2500", k)
  stats ARG1 using "mu_".load_lbf name "M" nooutput
  set label 10+k load_lbf." lbf" at 0.0203,M_max left
}
plot for [n=1:4] ARG1 using 1:n+1 with lines lt n+1
unset multiplot
