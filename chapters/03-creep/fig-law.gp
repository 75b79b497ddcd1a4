load "style.gp"
set output ARG2
set terminal pngcairo size 900,370
set xlabel "contact area over that of the new wheel"
set ylabel "creep over that of the new wheel"
set xrange [1:1.5]
set yrange [0.5:1]
set key bottom left font ",12" samplen 2
plot ARG1 using 1:2 with lines lt 8 title "creep × area constant", \
     ARG1 using 1:3 with lines lt 2 title "profile wears flat, µ/µ_c = 0.25", \
     ARG1 using 1:4 with lines lt 1 title "0.5", \
     ARG1 using 1:5 with lines lt 3 title "0.8"
