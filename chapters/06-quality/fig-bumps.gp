# alt: Against the length of a bump, the peak of the descriptor is near 0.95 at 3 m and falls to 0.02 at 200 m; the largest stroke is 0.4 up to 35 m and then falls, and the two meet between 80 and 90 m.
load "style.gp"
set terminal pngcairo size 740,310 font "DejaVu Sans,11"
set output ARG2
unset key
set logscale x
set xrange [3:200]
set yrange [0:1.1]
set xtics (3,5,10,20,50,100,200)
set rmargin 2
set xlabel "length of the bump, 1.6 cm high, m"
set ylabel "fraction of the limit"
set label "descriptor, its peak" at 9,0.95 font ",11" textcolor rgb blue
set label "stroke at the worst speed\nfrom 5 to 100 km/h" at 3.4,0.30 font ",11"
plot ARG1 using "length_m":"descriptor" with linespoints lt 2 dt 1, \
     ARG1 using "length_m":"stroke" with linespoints lt 1
