load "style.gp"
set output ARG2
unset key
set xrange [-150:150]
set xlabel "distance, m"
set ylabel "smooth part of h, 1/(cm m)"
set label "and an impulse of 1/(1.6 cm) at 0" at 4,0.0032
set arrow from 0,0 to 0,0.0035 filled lw 2.6 lc rgb red
set yrange [-0.018:0.005]
plot ARG1 using "distance_m":"response_per_cm_m" with lines lt 1
