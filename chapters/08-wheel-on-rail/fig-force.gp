load "style.gp"
set output ARG2
set xlabel "shift towards the wheel's flange, mm (left wheel negative)"
set ylabel "force along the track, N"
set key bottom left
plot ARG3 using 1:2 with points lt 2 title "CONTACT", \
     ARG1 using 1:2 with lines lt 1 title "full theory", \
     ARG1 using 1:3 with lines lt 3 title "strips", \
     ARG1 using 1:4 with lines lt 4 title "Hertz"
