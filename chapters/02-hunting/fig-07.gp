load "style.gp"
set output ARG2
set xlabel "amplitude of the wheelset A, in"
set ylabel "N_R (per x_w/a)"
set xrange [0:0.75]
set yrange [0:*]
set x2range [0:0.75/29.76]
set x2tics 0.005
set x2label "A/a"
set tmargin 4.5
set key top left
set label 1 "profiles reconstructed" at graph 0.98,0.04 right tc rgb grey
plot ARG1 using "A_in":"new" with lines lt 1 title "new wheel", \
     ARG1 using "A_in":"cn" with lines lt 2 title "CN A", \
     ARG1 using "A_in":"heumann" with lines lt 3 title "mod. Heumann"
