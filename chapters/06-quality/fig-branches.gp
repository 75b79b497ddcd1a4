load "style.gp"
set output ARG2
set xrange [0.3:1.8]
set yrange [0:8]
set key top left title "stops reconstructed, κ = 10"
set xlabel "frequency, Hz"
set ylabel "largest stroke, cm"
set arrow from 0.3,2.54 to 1.8,2.54 nohead ls guide
set label "limit 2.54 cm" at 1.79,2.7 right
plot ARG1 using "frequency_Hz":"stroke_cm" with lines lt 8 title "harmonic balance", \
     ARG3 using (column("stable") == 1 ? column("frequency_Hz") : NaN):"stroke_cm" with points lc rgb black pt 7 ps 0.8 title "exact, stable", \
     ARG3 using (column("stable") == 0 ? column("frequency_Hz") : NaN):"stroke_cm" with points lc rgb red pt 6 ps 0.9 title "exact, unstable", \
     ARG4 using (column("up") == 1 ? column("frequency_Hz") : NaN):"stroke_cm" with lines lt 2 title "sweep up", \
     ARG4 using (column("up") == 0 ? column("frequency_Hz") : NaN):"stroke_cm" with lines lt 3 title "sweep down"
