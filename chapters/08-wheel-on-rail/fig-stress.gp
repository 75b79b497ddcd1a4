load "style.gp"
set output ARG2
set xlabel "depth, mm"
set ylabel "von Mises stress over the largest pressure"
set yrange [0:0.8]
set key top right
plot ARG1 using 1:2 every :::0::0 with lines lt 1 title "3 mm, sliding", \
     ARG1 using 1:3 every :::0::0 with lines lt 2 title "its pressure alone", \
     ARG1 using 1:2 every :::1::1 with lines lt 3 title "8 mm, on the flange, sliding", \
     ARG1 using 1:3 every :::1::1 with lines lt 4 title "its pressure alone"
