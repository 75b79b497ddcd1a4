# ARG1, ARG3: the two sweeps; ARG4, ARG5: branches. What did not converge has no speed: a strip of its own at the right.
load "style.gp"
set terminal pngcairo size 900,430 font "DejaVu Sans,14" enhanced background rgb "white"
set output ARG2
set multiplot
set yrange [0:0.8]
set tmargin at screen 0.96
set bmargin at screen 0.19
set lmargin at screen 0.12
set rmargin at screen 0.84
set xlabel "speed V, ft/s"
set ylabel "largest wheelset amplitude A, in" offset 0.5
set xrange [90:250]
set key at graph 0.995,0.4 right top font ",11" samplen 1.5
plot ARG4 using 2:1 with lines lt 8 dt solid title "first family, by continuation", \
     ARG5 using 2:1 with lines lt 8 dt (6,4) title "second family, by continuation", \
     ARG1 using 2:1 with points pt 7 ps 1.1 lc rgb black title "least damped mode (the paper's)", \
     ARG3 using 2:1 with points pt 4 ps 1.3 lc rgb blue title "next least damped (its footnote)"
set lmargin at screen 0.86
set rmargin at screen 0.985
set ytics scale 0
unset key
unset ylabel
set format y ""
unset xlabel
set xrange [0:3]
unset xtics
set label 1 "did not\nconverge" at graph 0.5,-0.1 center tc rgb grey
plot ARG1 using ($3 == 1 ? 1 : NaN):1 with points pt 2 ps 0.9 lc rgb black, \
     ARG3 using ($3 == 1 ? 2 : NaN):1 with points pt 2 ps 0.9 lc rgb blue
unset multiplot
