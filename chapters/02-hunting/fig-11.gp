load "style.gp"
set terminal pngcairo size 1000,800 font "DejaVu Sans,14" enhanced background rgb "white"
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
set y2label "mm"
set border 15
set tmargin 4.5
set rmargin 9
set key at graph 0.985,0.985 right top font ",12"
set label 1 "profiles, dampers and\nwidth of friction\nreconstructed" at graph 0.985,0.3 right tc rgb grey
plot ARG1 using 1:5 with lines lw 3 dt (2,3) lc rgb black, \
     ARG1 using 1:4 with lines lw 2 dt (8,5) lc rgb black, \
     ARG3 using 1:4 with lines lw 2 dt (8,5) lc rgb blue, \
     ARG4 using 1:4 with lines lw 2 dt (8,5) lc rgb red, \
     ARG5 using 1:4 with lines lw 2 dt (8,5) lc rgb green, \
     ARG1 using 1:3 with lines lw 3 dt solid lc rgb black title "new wheel", \
     ARG3 using 1:3 with lines lw 3 dt solid lc rgb blue title "CN A", \
     ARG4 using 1:3 with lines lw 3 dt solid lc rgb red title "mod. Heumann", \
     ARG5 using 1:3 with lines lw 3 dt solid lc rgb green title "CN A, friction", \
     NaN with lines lw 2 dt (8,5) lc rgb grey title "paper's rule: unstable", \
     NaN with lines lw 3 dt (2,3) lc rgb grey title "neutral", \
     ARG6 using 1:2 with points pt 7 ps 1.0 lc rgb purple title "Floquet: stable", \
     ARG6 using 1:3 with points pt 6 ps 1.0 lw 1.6 lc rgb purple title "Floquet: unstable"
