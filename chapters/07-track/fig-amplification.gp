load "style.gp"
set terminal pngcairo size 1300,560
set output ARG2
set xlabel "speed over critical speed, θ = V / V_c"
set ylabel "largest deflection / static deflection"
set rmargin 46
set key outside right top
set xrange [0:2.5]
set yrange [0:5]
set arrow from 1,0 to 1,5 nohead ls guide
plot ARG3 using 1:2 with lines lt 1 title "no damping: 1/√(1−θ^2)", \
     ARG1 using 1:2 with lines lt 2 title "ζ = 0.05", \
     ARG1 using 1:3 with lines lt 3 title "ζ = 0.2", \
     ARG1 using 1:4 with lines lt 4 title "ζ = 0.4", \
     ARG1 using 1:5 with lines lt 5 title "ζ = 1", \
     ARG4 using 1:2 with points ls printed title "150 and 250 mph if V_c = 1100 mph", \
     ARG5 using 1:2 with points ls other title "150 and 250 mph on the typical track"
