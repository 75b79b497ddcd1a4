load "style.gp"
set output ARG2
set multiplot layout 2,1
unset key
set xlabel "time, s"
set ylabel "peaks of the rear\nleading wheelset, in"
set xrange [0:24]
set yrange [0.3:0.47]
set label 1 "154 ft/s" at graph 0.02, graph 0.9
plot ARG1 using "t_s":"peak_in" with linespoints lt 1 lw 1 pt 7 ps 0.5 notitle
set label 1 "160 ft/s, until a wheelset leaves its table" at graph 0.02, graph 0.08
set ylabel "peaks, in"
set xrange [0:5]
set yrange [0.3:0.75]
set key default
set key top right horizontal noautotitle opaque box lc rgb "#BBBBBB" width 1 height 0.3 samplen 3.5
plot ARG3 using "t_s":"peak_in" with linespoints lt 2 pt 7 ps 0.5 title "front leading wheelset", \
     ARG4 using "t_s":"peak_in" with linespoints lt 1 pt 7 ps 0.5 title "rear leading wheelset"
unset multiplot
