load "style.gp"
set output ARG2
set xlabel "x across the rail, in"
set ylabel "p(x, 0), 10^5 psi"
set xrange [-0.65:0.15]
set yrange [0:3.6]
set key top left
set arrow from 0, graph 0 to 0, graph 1 nohead ls guide
set label "crown, 10 in" at -0.02,0.22 right
set label "corner, 1.25 in" at 0.07,0.6 left rotate by 90
plot ARG3 using "x_in":"p_1e5_psi" with lines lt 1 title "concave tread, CG-FFT", \
     ARG1 using "x_in":"p_1e5_psi" with points lt 3 title "concave tread, COUNTACT-1, 30 columns", \
     ARG4 using "x_in":"p_1e5_psi" with lines lt 2 title "cone (rejected)"
