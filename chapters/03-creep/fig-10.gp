# alt: Hertz's area against load as a curve, and four synthetic points above it, labelled with their ratio to it.
load "style.gp"
set output ARG2
set terminal pngcairo size 740,320 font "DejaVu Sans,12" enhanced background rgb "white"
set xlabel "normal load, lbf"
set ylabel "contact area, mm²"
set xrange [0:3000]
set yrange [0:18]
unset key
set label "Hertz, longer axis along rolling" at 2000,5.2 left
set label "synthetic points: test and its area over Hertz's" at graph 0.03, 0.95 tc rgb "#BE5400"
plot ARG1 using 1:2 with lines lt 1, ARG3 using 1:2 with points lt 2, ARG3 using 1:2:3 with labels offset 0,1.1
