load "style.gp"
set terminal pngcairo size 1300,520
set output ARG2
set logscale x
set xrange [2:500]
set yrange [-0.02:1.04]
set xtics (2, 5, 10, 20, 50, 100, 500)
set xlabel "length of record, km"
set ylabel "probability of class"
set key at screen 0.5, screen 0.99 center top horizontal maxrows 1 nobox
set tmargin 5
names = "7 10 12"
set multiplot layout 1,3
do for [z = 1:3] {
  set title "zone ".word(names, z) offset 0,-0.6
  plot for [m = 2:5] ARG1 using (strcol("zone") eq word(names, z) ? column("length_km") : NaN):sprintf("class_%d", m) \
         with lines lt m-1 title (z == 1 ? sprintf("class %d", m) : ""), \
       for [m = 2:5] ARG3 using (strcol("zone") eq word(names, z) ? column("length_km") : NaN):sprintf("class_%d", m) \
         with points lt m-1 ps 1.6 title ""
  set key off
}
unset multiplot
