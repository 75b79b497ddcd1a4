# alt: Pressure along the axis of the roller: nearly even in the middle, a low shoulder beyond the end of the straight part for the crown of 85 in, a higher one for 10 in, and a spike at the square end.
load "style.gp"
set terminal pngcairo size 740,330 font "DejaVu Sans,12" enhanced background rgb "white"
set output ARG2
set xlabel "x along the axis, in"
set ylabel "pressure on the axis, 10^5 psi"
set xrange [-0.82:0.82]
set yrange [0:3.2]
set key bottom center samplen 2 width -1
set arrow from -0.5, graph 0 to -0.5, graph 1 nohead ls guide
set arrow from 0.5, graph 0 to 0.5, graph 1 nohead ls guide
set label "end of the\nstraight part" at 0.52, 3.05
plot ARG4 using "x_in":"p_1e5psi" with lines lt 3 title "square ends", \
     ARG5 using "x_in":"p_1e5psi" with lines lt 2 title "crown 10 in", \
     ARG1 using "x_in":"p_1e5psi" with lines lt 1 title "crown 85 in, CG-FFT", \
     ARG3 using "x_in":"p_1e5psi" with points ls other title "crown 85 in, COUNTACT-2"
