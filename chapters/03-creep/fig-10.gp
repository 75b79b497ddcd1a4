load "style.gp"
set output ARG2
set terminal pngcairo size 900,370
set xlabel "normal load, lbf"
set ylabel "contact area, mm²"
set xrange [0:3000]
set yrange [0:18]
unset key
set label "Hertz" at 2450,7.2 left
set label "synthetic points: area over Hertz's" at graph 0.03, 0.95 tc rgb "#D55E00"
plot ARG1 using 1:2 with lines lt 1 title "Hertz", \
     ARG3 using 1:2 with points lt 2 title "synthetic, worn wheels: area over Hertz's", \
     ARG3 using 1:2:3 with labels offset 0,1.1
