load "style.gp"
set terminal pngcairo size 1000,800
set output ARG2
set multiplot layout 2,1
set lmargin 9
set yrange [-4:4]
set xrange [0:70]
set ylabel "stroke, cm"
set key above horizontal maxrows 1
set arrow from graph 0,first 2.54 to graph 1,first 2.54 nohead ls guide
set arrow from graph 0,first -2.54 to graph 1,first -2.54 nohead ls guide
plot ARG1 using "time_s":"sudden_cm" with lines lt 1 lw 1 title "begun at once, stroke at rest (dashed: limit of 2.54 cm)"
set xlabel "time, s"
plot ARG1 using "time_s":"ramp_cm" with lines lt 2 lw 1 dt solid title "grown over 60 s (model reconstructed)"
unset multiplot
