# alt: Pressures of the last three cells of a column and two parabolas on their sides. The one through two cells falls to zero at the old boundary, outside the last cell; the one through three turns back at the last cell and reaches zero far inside.
load "style.gp"
set terminal pngcairo size 740,330 font "DejaVu Sans,12" enhanced background rgb "white"
set output ARG2
set xlabel "y along the rail, in"
set ylabel "p, 10^4 psi"
set xrange [0.03:0.08]
set yrange [-0.2:4.2]
stats ARG3 using "boundary_in" name "old" nooutput
stats ARG3 using "y_in" name "new" nooutput
set arrow from old_max, graph 0 to old_max, graph 1 nohead lc rgb blue lw 1.6 dt (14,5)
set label "old boundary" at old_max, graph 0.5 rotate by 90 offset 1,0 textcolor rgb blue
set arrow from graph 0, first 0 to graph 1, first 0 nohead ls guide
unset key
set label "solid: parabola through two points\ndash-dotted: through three" at 0.033,1.5
set label "pressures of the cells" at 0.054,3.1
set label "new boundary" at new_max, first 0 offset -1.6,0.8 right textcolor rgb "#BE5400"
plot ARG1 using "y_in":"p_1e4_psi" with points lt 1 ps 1.6, \
     ARG4 using "y_in":"p_1e4_psi" with lines lt 1, \
     ARG5 using "y_in":"p_1e4_psi" with lines lt 3, \
     ARG3 using "y_in":"p_1e4_psi" with points pt 6 ps 1.8 lw 2.4 lc rgb red
