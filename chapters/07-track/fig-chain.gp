load "style.gp"
set output ARG2
set terminal pngcairo size 1300,560
set multiplot layout 1,3
set yrange [0:70]
set ytics 10
set rmargin 2
set ylabel "stiffness under one wheel K_r, MN/m"
set key top right
set xlabel "tie spacing, in"
set xrange [15:36]
set xtics 5
plot ARG1 using 1:2 with lines lt 1 title "equations (2)–(7)", \
     ARG5 using "spacing":"K_r" with points ls other title "typical track"
unset key
unset ylabel
set xlabel "ballast depth, in"
set xrange [0:30]
stats ARG5 using "overlap_in" nooutput
overlap = STATS_min
plot ARG3 using 1:($1 <= overlap ? $2 : NaN) with lines lt 1, \
     ARG3 using 1:($1 >= overlap ? $2 : NaN) with lines lt 4 lc rgb black, \
     ARG5 using "depth":"K_r" with points ls other
set xlabel "soil modulus, lb/in³"
set xrange [20:500]
set logscale x
set xtics (20,50,100,200,500)
plot ARG4 using 1:2 with lines lt 1, ARG5 using "soil":"K_r" with points ls other
unset multiplot
