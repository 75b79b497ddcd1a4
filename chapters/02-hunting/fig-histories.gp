load "style.gp"
set output ARG2
set multiplot layout 2,1
unset key
set label 1 "reconstructed profiles" at graph 0.98, graph 0.12 right tc rgb grey
set xlabel "time, s"
set ylabel "peaks of the rear leading\nwheelset, in"
set xrange [0:100]
set yrange [0:0.45]
set ytics 0.1
plot ARG1 using "t_s":"peak_in" with points pt 7 ps 0.6 lc rgb blue
unset label 1
set ylabel "its displacement, in"
set xlabel "time after a crossing, s"
set xrange [0:1.5]
set yrange [-0.6:1.2]
set ytics 0.4
set key default
set key top center horizontal noautotitle opaque box lc rgb "#BBBBBB" width 1 height 0.3 samplen 3.5 spacing 1.1
plot ARG3 using (strcol("method") eq "time" ? column("t_s") : NaN):"x_in" with lines lc rgb grey lw 7 title "in time", \
     ARG3 using (strcol("method") eq "balance" ? column("t_s") : NaN):"x_in" with lines lt 1 lw 2 title "23 harmonics", \
     ARG3 using (strcol("method") eq "describing" ? column("t_s") : NaN):"x_in" with lines lt 3 title "describing function"
unset multiplot
