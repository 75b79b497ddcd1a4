# alt: Above, the gap under the stamp, zero to 0.5 in and rising beyond. Below, the pressure: ten thousand psi in the middle, rising to eighty thousand just outside the flat and falling to zero, while that of a sharp punch grows without bound. Right, the edge enlarged with the points of the rings.
load "style.gp"
set terminal pngcairo size 740,420 font "DejaVu Sans,12" enhanced background rgb "white"
set output ARG2
set multiplot
unset key
set tmargin 0
set lmargin at screen 0.1
set rmargin at screen 0.53
set bmargin at screen 0.73
set tmargin at screen 0.94
set xrange [0:0.6]
set ylabel "gap, 10^{-3} in"
set yrange [-0.6:6]
set ytics 2
set format x ""
plot ARG4 using "r_in":"gap_1e-3_in" with lines lt 1
set format x "%g"
set bmargin at screen 0.16
set tmargin at screen 0.69
set xlabel "ρ, in"
set ylabel "p, 10^4 psi"
set yrange [0:10]
set ytics 2
set label 1 "sharp punch" at 0.47,7 right textcolor rgb blue
set label 2 "rounded edge" at 0.3,2.3 right
plot ARG3 using "r_in":"p_1e4_psi" with lines lt 1, \
     ARG1 using "r_in":"p_1e4_psi" with points lt 3 ps 0.6, \
     ARG5 using "r_in":"p_1e4_psi" with lines lt 2
set lmargin at screen 0.62
set rmargin at screen 0.97
set tmargin at screen 0.94
set xrange [0.485:0.515]
set xtics 0.01
unset ylabel
set label 1 "sharp" at 0.4955,9.2 right
set label 2 "line: closed form\npoints: rings of COUNTAXI" at 0.4865,1.6 left
plot ARG3 using "r_in":"p_1e4_psi" with lines lt 1, \
     ARG1 using "r_in":"p_1e4_psi" with points lt 3, \
     ARG5 using "r_in":"p_1e4_psi" with lines lt 2
unset multiplot
