# alt: Left: two curves of contact area against load that grow with its power of two thirds, the one for the longer axis across higher by more than half. Right: the lower curve again, and four synthetic points above it, labelled with their ratio to it.
load "style.gp"
set output ARG2
set terminal pngcairo size 1100,280 font "DejaVu Sans,13" enhanced background rgb "white"
set multiplot layout 1,2 margins 0.06,0.985,0.21,0.95 spacing 0.06
set xlabel "normal load, lbf" offset 0,0.4
set ylabel "contact area, mm²"
set xrange [0:3000]
set yrange [0:18]
set ytics 4
unset key
set label 1 "longer axis across rolling" at 1480,12 right tc rgb "#3A799C"
set label 2 "longer axis along rolling" at 1500,5 left
plot ARG1 using 1:3 with lines lt 7, ARG1 using 1:2 with lines lt 1
unset ylabel
set label 1 "synthetic points: area over Hertz's" at graph 0.03, 0.95 left tc rgb "#BE5400"
set label 2 "Hertz, longer axis along rolling" at 1750,4.6 left
plot ARG1 using 1:2 with lines lt 1, ARG3 using 1:2 with points lt 2, ARG3 using 1:2:3 with labels offset 0,1.1
unset multiplot
