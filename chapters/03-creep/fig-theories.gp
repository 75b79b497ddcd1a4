load "style.gp"
set output ARG2
set xlabel "G a b ξ/(µ_c N)"
set ylabel "µ/µ_c less that of the full theory"
set xrange [0:1.2]
set xzeroaxis ls guide
set key top right
plot ARG1 using 1:6 with lines lt 8 title "Vermeulen-Johnson, own slope", \
     ARG1 using 1:3 with lines lt 2 title "strips", \
     ARG1 using 1:5 with lines lt 4 title "Polach", \
     ARG1 using 1:4 with lines lt 3 title "Shen-Hedrick-Elkins", \
     ARG1 using 1:2 with lines lt 1 title "FASTSIM"
