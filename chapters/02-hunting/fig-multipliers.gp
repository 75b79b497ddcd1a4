load "style.gp"
set output ARG2
set xlabel "speed, ft/s"
set ylabel "modulus of the multipliers, a period"
set xrange [144:166]
set yrange [0:3]
set arrow 1 from 144, 1 to 166, 1 nohead ls guide
set key top left
set label 1 "reconstructed profiles" at graph 0.98, graph 0.05 right tc rgb grey
plot ARG1 using "V_ft_s":"pair" with lines lt 1 title "largest complex pair", \
     ARG1 using "V_ft_s":"real" with lines lt 2 title "largest real (the trivial one left out)", \
     ARG3 using "V_ft_s":"pair" with points pt 7 ps 2 lc rgb red title "torus point"
