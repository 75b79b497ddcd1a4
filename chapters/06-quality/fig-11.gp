load "style.gp"
set terminal pngcairo size 1000,660
set output ARG2
set multiplot layout 2,1
set lmargin 9
set xrange [0:10]
set key top left title "reconstructed"
set ylabel "standard deviation s"
set yrange [0:0.6]
plot ARG1 using "tonnage":"s_A" with lines lt 1 title "A: ties renewed", \
     ARG1 using "tonnage":"s_B" with lines lt 3 title "B: surfaced only"
set key top right notitle
set ylabel "n = T_2/s"
set xlabel "tonnage, arbitrary units"
set yrange [0:6]
set arrow from 0,3 to 10,3 nohead ls guide
plot ARG1 using "tonnage":"n_A" with lines lt 1 title "A", \
     ARG1 using "tonnage":"n_B" with lines lt 3 title "B"
unset multiplot
