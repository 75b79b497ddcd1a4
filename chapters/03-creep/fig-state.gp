load "style.gp"
set output ARG2
set terminal pngcairo size 900,370
set xlabel "largest friction coefficient µ_c, assumed"
set ylabel "true area over Hertz's"
set xrange [0.3:1]
set yrange [0.8:3.2]
unset key
set label "creep smaller by 0.0005" at 0.55,2.3 left tc rgb "#0072B2"
set label "as printed: 4449.72 N, µ = 0.3, 442.6 and 99.2 rpm" at 0.5,1.76 left
set label "creep larger by 0.0005" at 0.55,1.38 left tc rgb "#D55E00"
set arrow from 0.3,1 to 1,1 nohead ls guide
set label "Hertz's area" at 0.98,0.94 right tc rgb grey
plot ARG1 using 1:4 with lines lt 2 title "creep smaller by 0.0005", \
     ARG1 using 1:2 with lines lt 1 title "as printed: 4449.72 N, µ = 0.3, 442.6 and 99.2 rpm", \
     ARG1 using 1:3 with lines lt 3 title "creep larger by 0.0005"
