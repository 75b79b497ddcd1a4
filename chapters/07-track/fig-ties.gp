load "style.gp"
set output ARG2
set logscale xy
set xlabel "tie spacing over characteristic length, βl_t"
set ylabel "deviation from the smeared foundation"
set format y "10^{%T}"
set xrange [0.1:2]
set yrange [1e-7:1]
set xtics (0.1,0.2,0.5,1,2)
set key top left
stats ARG4 using "beta_spacing" nooutput
set arrow from STATS_min,1e-7 to STATS_min,1 nohead ls guide
set label "typical track" at STATS_min*1.03,3e-7 tc rgb "#606060"
plot ARG1 using 1:2 with lines lt 1 title "stiffer over a tie", \
     ARG1 using 1:3 with lines lt 2 title "softer at midspan", \
     ARG3 using 1:2 with points ls other title "beam elements on tie springs", \
     ARG3 using 1:3 with points ls other
