# alt: Pressure along x. It rises slowly from -0.57 in over the crown, steeply near the jump at 0 to a peak of three hundred thousand psi, and falls to zero within 0.06 in over the corner. A coned wheel has a shorter contact with a higher peak.
load "style.gp"
set terminal pngcairo size 740,330 font "DejaVu Sans,12" enhanced background rgb "white"
set output ARG2
set xlabel "x across the rail, in"
set ylabel "p(x, 0), 10^5 psi"
set xrange [-0.6:0.1]
set yrange [0:3.6]
set key top left
set arrow from 0, graph 0 to 0, graph 1 nohead ls guide
set label "crown, 10 in" at -0.01,0.25 right
set label "corner, 1.25 in" at 0.086,0.3 left rotate by 90
plot ARG3 using "x_in":"p_1e5_psi" with lines lt 1 title "hollow tread, CG-FFT", \
     ARG1 using "x_in":"p_1e5_psi" with points lt 3 title "hollow tread, COUNTACT-1", \
     ARG4 using "x_in":"p_1e5_psi" with lines lt 2 title "cone"
