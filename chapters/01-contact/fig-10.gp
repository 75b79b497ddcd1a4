load "style.gp"
set output ARG2
set xlabel "x across the rail, in"
set ylabel "y along the rail, in"
set size ratio -1
set xrange [-0.78:0.2]
set yrange [-0.46:0.46]
set key outside top center horizontal
set arrow from 0, graph 0 to 0, graph 1 nohead ls guide
plot ARG1 using "x_in":"y_in":(0.5*column("dx_in")):(0.5*column("dy_in")) with boxxyerror fs empty lc rgb black lw 1 title "last mesh of COUNTACT-1", \
     ARG3 using "x_in":"y_in" with lines lt 3 title "interpenetration curve"
