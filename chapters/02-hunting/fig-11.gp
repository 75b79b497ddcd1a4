# ARG1, ARG3 to ARG5: describing functions of the four cars; ARG6: branches of the equations, a block a car; ARG7: their special points.
load "style.gp"
set terminal pngcairo size 900,610 font "DejaVu Sans,14" enhanced background rgb "white"
set output ARG2
set xlabel "speed V, ft/s"
set ylabel "largest wheelset amplitude A, in"
set xrange [0:250]
set yrange [0:0.75]
set x2range [0:250*0.3048]
set y2range [0:0.75*25.4]
set x2tics 10
set y2tics 2
set x2label "m/s"
set y2label "mm" offset -1
set border 15
set tmargin 4
set rmargin 8
set key at graph 0.985,0.42 right top font ",12" samplen 2 width 0
array colour[4] = [black, blue, red, green]
array file[4] = [ARG1, ARG3, ARG4, ARG5]
set label 1 "new wheel" at 147,0.03 tc rgb black
set label 2 "CN A" at 128,0.10 right tc rgb blue
set label 3 "Heumann" at 84,0.16 right tc rgb red
set label 4 "CN A,\nfriction" at 60,0.055 right tc rgb green
plot for [k = 1:4] file[k] using 1:3 with lines lw 1.2 dt solid lc rgb colour[k], \
     for [k = 1:4] file[k] using 1:4 with lines lw 1.2 dt (6,5) lc rgb colour[k], \
     for [k = 1:4] file[k] using 1:5 with lines lw 1.2 dt (2,3) lc rgb colour[k], \
     for [k = 1:4] ARG6 every :::k-1::k-1 using 1:4 with lines lw 3 dt (3,2) lc rgb colour[k], \
     for [k = 1:4] ARG6 every :::k-1::k-1 using 1:5 with lines lw 3 dt (1,1.5) lc rgb colour[k], \
     for [k = 1:4] ARG6 every :::k-1::k-1 using 1:3 with lines lw 4 dt solid lc rgb colour[k], \
     NaN with lines lw 4 dt solid lc rgb grey title "equations: stable", \
     NaN with lines lw 3 dt (3,2) lc rgb grey title "unstable", \
     NaN with lines lw 1.2 dt solid lc rgb grey title "paper's rule: stable", \
     NaN with lines lw 1.2 dt (6,5) lc rgb grey title "unstable ", \
     ARG7 using 1:2 with points pt 6 ps 1.3 lw 1.8 lc rgb purple title "fold", \
     ARG7 using 1:3 with points pt 4 ps 1.3 lw 1.8 lc rgb purple title "torus", \
     ARG7 using 1:4 with points pt 8 ps 1.3 lw 1.8 lc rgb purple notitle
