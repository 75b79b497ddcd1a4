load "style.gp"
set output ARG2
set xlabel "y along the rail, in"
set ylabel "p, 10^4 psi"
set xrange [0:0.14]
set key bottom left
set arrow from graph 0, first 0 to graph 1, first 0 nohead ls guide
stats ARG3 using "boundary_in" name "old" nooutput
set arrow from old_max, graph 0 to old_max, graph 1 nohead lc rgb blue lw 1.6 dt (14,5)
set label "old boundary" at old_max, graph 0.6 rotate by 90 offset 1,0
plot ARG1 using "y_in":"p_1e4_psi" with linespoints lt 1 title "pressures of the column under O", \
     ARG3 using "y_in":"p_1e4_psi" with points pt 6 ps 1.8 lw 2.4 lc rgb red title "new boundary"
