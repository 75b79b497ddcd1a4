load "style.gp"
set output ARG2
set xlabel "x along the axis, in"
set ylabel "pressure on the axis, 10^5 psi"
set xrange [-0.85:0.85]
set yrange [0:3.2]
set key bottom center
set arrow from -0.5, graph 0 to -0.5, graph 1 nohead ls guide
set arrow from 0.5, graph 0 to 0.5, graph 1 nohead ls guide
set label "end of the flat" at 0.51, 3.05
plot ARG4 using "x_in":"p_1e5psi" with lines lt 3 title "square ends (peak grows without bound)", \
     ARG5 using "x_in":"p_1e5psi" with lines lt 2 title "crown radius 10 in", \
     ARG1 using "x_in":"p_1e5psi" with lines lt 1 title "crown radius 85 in, CG-FFT", \
     ARG3 using "x_in":"p_1e5psi" with points ls other title "crown radius 85 in, COUNTACT-2"
