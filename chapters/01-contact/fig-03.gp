load "style.gp"
set output ARG2
set xlabel "y along the rail, in"
set ylabel "p, 10^4 psi"
set xrange [0:0.14]
set key top right
set arrow from graph 0, first 0 to graph 1, first 0 nohead ls guide
stats ARG3 using "boundary_in" name "old" nooutput
stats ARG3 using "y_in" name "new" nooutput
set arrow from old_max, graph 0 to old_max, graph 1 nohead lc rgb blue lw 1.6 dt (14,5)
set label "old boundary" at old_max, graph 0.6 rotate by 90 offset 1,0
set arrow from new_max, graph 0.32 to new_max, first 0 head filled lc rgb red lw 2
set label "new boundary" at new_max, graph 0.35 center
plot ARG1 using "y_in":"p_1e4_psi" with linespoints lt 1 title "pressures of the column under O, and linear interpolation", \
     ARG3 using "y_in":"p_1e4_psi" with points pt 6 ps 1.8 lw 2.4 lc rgb red title "its zero"
