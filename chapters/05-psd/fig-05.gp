# alt: Two records of a rail with 40 joints. Above, deep and shallow dips follow each other at
# alt: random; below, deep dips stand in groups, with stretches of shallow ones between.
load "style.gp"
set terminal pngcairo size 1000,430
set output ARG2
unset key
set multiplot layout 2,1
set lmargin 9
set xrange [0:475.5]
set yrange [-30:8]
set ytics 10
set ylabel "height, mm"
set title "(a) dips random from joint to joint"
plot ARG1 using "x_m":"random_mm" with lines lc rgb black lw 1.8
set title "(b) the same scatter, in groups: five deep joints in a row on average"
set xlabel "distance, m"
plot ARG1 using "x_m":"grouped_mm" with lines lc rgb black lw 1.8
unset multiplot
