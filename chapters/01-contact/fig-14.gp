load "style.gp"
set output ARG2
set multiplot
unset key
set lmargin 0
set rmargin 0
set tmargin 0
set bmargin 0
set xrange [0:0.6]
set lmargin at screen 0.1
set rmargin at screen 0.5
set bmargin at screen 0.78
set tmargin at screen 0.91
set ylabel "gap, 10^{-3} in"
set yrange [-0.6:6]
set ytics 2
set format x ""
set title "profile of the stamp"
plot ARG4 using "r_in":"gap_1e-3_in" with lines lt 1
set format x "%g"
set title ""
set bmargin at screen 0.14
set tmargin at screen 0.72
set xlabel "r, in"
set ylabel "p, 10^4 psi"
set yrange [0:10]
set ytics 2
set key default
set key noautotitle opaque box lc rgb "#BBBBBB" left center
plot ARG3 using "r_in":"p_1e4_psi" with lines lt 1 title "closed form", \
     ARG1 using "r_in":"p_1e4_psi" with points lt 3 ps 0.8 title "COUNTAXI", \
     ARG5 using "r_in":"p_1e4_psi" with lines lt 2 title "sharp punch"
set lmargin at screen 0.58
set rmargin at screen 0.97
set tmargin at screen 0.91
set xrange [0.48:0.52]
set xtics 0.01
unset key
set title "the edge"
unset ylabel
plot ARG3 using "r_in":"p_1e4_psi" with lines lt 1, \
     ARG1 using "r_in":"p_1e4_psi" with points lt 3, \
     ARG5 using "r_in":"p_1e4_psi" with lines lt 2
unset multiplot
unset key
