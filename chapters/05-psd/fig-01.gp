# alt: Height of a rail along the distance: four equal arches of 11.9 m that meet in sharp dips, the
# alt: joints, a depth b below the crests.
load "style.gp"
set terminal pngcairo size 1000,330
set output ARG2
unset key
set xlabel "distance along the rail, m"
set ylabel "height / b"
set xrange [0:47.6]
set yrange [-0.1:1.35]
set ytics 0.5
set arrow from 5.94,0 to 5.94,1 heads filled size 0.5,20 lc rgb red lw 2
set label "b" at 6.5,0.5 textcolor rgb red font ",18"
set arrow from 11.887,1.15 to 23.774,1.15 heads filled size 0.5,20 lc rgb blue lw 2
set label "rail length 11.9 m (39 ft)" at 17.83,1.25 center textcolor rgb blue
set label "joint" at 36.1,-0.04
plot ARG1 using "x_m":"z_over_B" with lines lt 1
