# alt: Pressures of five cells along y, falling from a positive value in the middle to a negative one at the old boundary; a circle marks where the line between them crosses zero.
load "style.gp"
set terminal pngcairo size 740,330 font "DejaVu Sans,12" enhanced background rgb "white"
set output ARG2
unset key
set xlabel "y along the rail, in"
set ylabel "p, 10^4 psi"
set xrange [0:0.125]
set yrange [-3.6:4.6]
set arrow from graph 0, first 0 to graph 1, first 0 nohead ls guide
stats ARG3 using "boundary_in" name "old" nooutput
stats ARG3 using "y_in" name "new" nooutput
set arrow from old_max, graph 0 to old_max, graph 1 nohead lc rgb blue lw 1.6 dt (14,5)
set label "old boundary" at old_max, graph 0.4 rotate by 90 offset 1,0 textcolor rgb blue
set label "new boundary" at new_max, first 0 offset 0.5,1.2 textcolor rgb "#BE5400"
set label "pressures of the cells" at graph 0.05, graph 0.6
plot ARG1 using "y_in":"p_1e4_psi" with linespoints lt 1, \
     ARG3 using "y_in":"p_1e4_psi" with points pt 6 ps 1.8 lw 2.4 lc rgb red
