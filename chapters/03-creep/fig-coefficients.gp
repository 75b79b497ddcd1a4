load "style.gp"
set output ARG2
set terminal pngcairo size 1300,800
set multiplot
set logscale x
set xrange [0.09:11]
set xtics (0.1,0.2,0.5,1,2,5,10)
array title[4] = ["C_{11}", "C_{22}", "C_{23}", "C_{33}"]
array top[4] = [14, 18, 20, 14]
array low[4] = [2, 2, 0.3, 0.2]
do for [k=1:4] {
  left = 0.06 + 0.243 * (k - 1)
  set lmargin at screen left
  set rmargin at screen left + 0.19
  set tmargin at screen 0.94
  set bmargin at screen 0.40
  set title title[k]
  set logscale y
  set yrange [low[k]:top[k]]
  set ytics (0.2,0.5,1,2,5,10,20)
  set xlabel ""
  set format x ""
  if (k == 1) { set key top left font ",11" samplen 2 } else { unset key }
  plot for [n=0:2] ARG1 using "ratio":(column(2+k)*(1+column(6+k)/100)) every :::n::n with points lc rgb word(red." ".blue." ".green, n+1) pt 6 ps 1.2 title "ν = ".word("0 0.25 0.5",n+1)." table", \
       for [n=0:2] ARG1 using "ratio":(column(2+k)) every :::n::n with lines lt n+1 lc rgb word(red." ".blue." ".green, n+1) title "computed"
  unset key
  unset title
  unset logscale y
  set tmargin at screen 0.36
  set bmargin at screen 0.13
  set yrange [-1.5:1.5]
  set ytics 0.5
  set format x "%g"
  set xlabel "a/b"
  if (k == 1) { set ylabel "table / computed - 1, %" } else { unset ylabel }
  plot for [n=0:2] ARG1 using "ratio":(column(6+k)) every :::n::n with linespoints lc rgb word(red." ".blue." ".green, n+1) lw 1.5 pt 6, 0 with lines ls guide
  unset ylabel
}
unset multiplot
