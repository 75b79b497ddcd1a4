load "style.gp"
set output ARG2
set xlabel "y along the rail, in"
set ylabel "p, 10^4 psi"
set xrange [0.02:0.09]
set yrange [-0.2:5]
set key top right
stats ARG3 using "boundary_in" name "old" nooutput
set arrow from old_max, graph 0 to old_max, graph 1 nohead lc rgb blue lw 1.6 dt (14,5)
set label "old boundary" at old_max, graph 0.25 rotate by 90 offset 1,0
set arrow from graph 0, first 0 to graph 1, first 0 nohead ls guide
plot ARG1 using "y_in":"p_1e4_psi" with points lt 1 ps 1.6 title "pressures of the column under O", \
     ARG4 using "y_in":"p_1e4_psi" with lines lt 1 title "parabola through two points", \
     ARG5 using "y_in":"p_1e4_psi" with lines lt 3 title "parabola through three points", \
     ARG3 using "y_in":"p_1e4_psi" with points pt 6 ps 1.8 lw 2.4 lc rgb red title "new boundary"
