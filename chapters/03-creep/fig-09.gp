# alt: Two curves of contact area against load that grow with its power of two thirds, the one for the longer axis across higher by more than half.
load "style.gp"
set output ARG2
set terminal pngcairo size 740,300 font "DejaVu Sans,12" enhanced background rgb "white"
set xlabel "normal load, lbf"
set ylabel "contact area, mm²"
set xrange [0:3000]
set yrange [0:15]
unset key
set label "longer axis across rolling" at 1480,11 right tc rgb "#3A799C"
set label "longer axis along rolling" at 1750,5.2 left
plot ARG1 using 1:3 with lines lt 7, ARG1 using 1:2 with lines lt 1
