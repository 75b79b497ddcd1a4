load "style.gp"
set output ARG2
set multiplot layout 2,1
set label 2 "reconstructed profiles" at graph 0.98, graph 0.06 right tc rgb grey
unset key
set xlabel "time, s"
set ylabel "peaks of the rear\nleading wheelset, in"
set xrange [0:80]
set yrange [0.3:0.47]
set label 1 "154 ft/s" at graph 0.02, graph 0.9
plot ARG1 using "t_s":"peak_in" with linespoints lt 1 lw 1 pt 7 ps 0.5 notitle
set label 1 "160 ft/s"
set ylabel "displacement, in"
set autoscale x
unset label 2
set yrange [-0.85:1.5]
set ytics 0.4
set arrow 1 from graph 0, first 0.75 to graph 1, first 0.75 nohead ls guide
set arrow 2 from graph 0, first -0.75 to graph 1, first -0.75 nohead ls guide
set key default
set key top right horizontal noautotitle opaque box lc rgb "#BBBBBB" width 1 height 0.3 samplen 3.5
plot ARG3 using "t_s":"front_in" with lines lt 2 title "front leading wheelset", \
     ARG3 using "t_s":"rear_in" with lines lt 1 title "rear leading wheelset"
unset multiplot
