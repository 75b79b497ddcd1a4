load "style.gp"
set output ARG2
set terminal pngcairo size 900,370
set xlabel "normal load, lbf"
set ylabel "contact area, mm²"
set xrange [0:3000]
set yrange [0:*]
set key bottom right
plot ARG1 using 1:3 with lines lt 7 title "Hertz, major axis across", \
     ARG1 using 1:2 with lines lt 1 title "Hertz, major axis along rolling"
