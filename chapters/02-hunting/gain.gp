load "style.gp"
set terminal pngcairo size 900,355 font "DejaVu Sans,14" enhanced background rgb "white"
set output ARG2
set xlabel "amplitude of the wheelset A, in"
set ylabel "describing function, per x_w/a"
set xrange [0:0.75]
set yrange [*:*]
set x2range [0:0.75/29.76]
set x2tics 0.005
set x2label "A/a"
set tmargin 4
set key top left
plot ARG1 using "A_in":"new" with lines lt 1 title "new wheel", \
     ARG1 using "A_in":"cn" with lines lt 2 title "CN A", \
     ARG1 using "A_in":"heumann" with lines lt 3 title "mod. Heumann"
