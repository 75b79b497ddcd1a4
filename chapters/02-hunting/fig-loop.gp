# ARG1, ARG3: the two sweeps; ARG4, ARG5: branches. What did not converge has no speed: a strip of its own at the right.
# alt: Amplitude against speed. Dots of the paper's search stand on the vertical line up to 0.39 in, and above 0.48 in on the dashed
# alt: second family; between, and for the next mode above, crosses in a strip at the right show that it did not converge.
load "style.gp"
set terminal pngcairo size 740,400 font "DejaVu Sans,12" enhanced background rgb "white"
set output ARG2
W = 740.0; H = 400.0
set multiplot
unset key
set yrange [0:0.78]
set tmargin at screen 382/H
set bmargin at screen 62/H
set lmargin at screen 78/W
set rmargin at screen 600/W
set xlabel "speed V, ft/s"
set ylabel "largest amplitude A, in" offset 1
set xrange [90:250]
set label 1 "by continuation:" at 182,0.3 tc rgb red
set label 2 "first family (solid)" at 186,0.255 tc rgb red
set label 3 "second family (dashed)" at 186,0.21 tc rgb red
set label 4 "by the paper's search:" at 182,0.14
set label 5 "least damped mode" at 190,0.095
set label 6 "next least damped" at 190,0.05 tc rgb blue
set label 7 "" at 187,0.095 point pt 7 ps 0.8 lc rgb black
set label 8 "" at 187,0.05 point pt 4 ps 1.0 lc rgb blue
plot ARG4 using 2:1 with lines lw 2 lc rgb red dt solid, \
     ARG5 using 2:1 with lines lw 2 lc rgb red dt (6,4), \
     ARG1 using 2:1 with points pt 7 ps 0.8 lc rgb black, \
     ARG3 using 2:1 with points pt 4 ps 1.0 lc rgb blue
unset label
set lmargin at screen 630/W
set rmargin at screen 725/W
set ytics scale 0
unset ylabel
set format y ""
unset xlabel
set xrange [0:3]
unset xtics
set label 1 "did not\nconverge" at graph 0.5,-0.06 center tc rgb grey
plot ARG1 using ($3 == 1 ? 1 : NaN):1 with points pt 2 ps 0.8 lc rgb black, \
     ARG3 using ($3 == 1 ? 2 : NaN):1 with points pt 2 ps 0.8 lc rgb blue
unset multiplot
