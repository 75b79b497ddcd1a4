load "style.gp"
set output ARG2
set xlabel "x across the rail, in"
set ylabel "y along the rail, in"
set xrange [-0.22:0.22]
set yrange [0:0.18]
set key top center horizontal maxcols 3
of(k) = column("iteration") == k ? column("x_in") : NaN
plot ARG3 using "x_in":"y_in":(0.5*column("dx_in")):(0.5*column("dy_in")) with boxxyerror fs empty lc rgb grey lw 0.8 title "last mesh", \
     ARG1 using (of(0)):"y_in" with lines lt 2 title "1: interpenetration curve", \
     "" using (of(1)):"y_in" with lines lt 3 title "2", \
     "" using (of(2)):"y_in" with lines lt 4 title "3", \
     "" using (of(3)):"y_in" with lines lt 1 title "4", \
     ARG4 using "x_in":"y_in" with lines lt 6 title "Hertz"
