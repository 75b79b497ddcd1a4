load "style.gp"
set output ARG2
set xlabel "x across the rail, in"
set ylabel "gap between the bodies, 10^{-6} in"
set xrange [-0.26:0.26]
set yrange [-450:320]
set key at 0,-110 center
set arrow from graph 0, first 0 to graph 1, first 0 nohead ls guide
plot ARG1 using "x_in":"before_microinch" with lines lt 2 title "undeformed, moved together by δ", \
     "" using "x_in":"after_microinch" with lines lt 1 title "deformed: zero in the contact", \
     ARG3 using "x_in":"z_microinch" with points pt 7 ps 1.4 lc rgb red, \
     "" using "x_in":"z_microinch":"label" with labels offset 0,1.2
