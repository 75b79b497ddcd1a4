load "style.gp"
set output ARG2
set multiplot layout 1,2
set xlabel "r, in"
set ylabel "p, 10^4 psi"
set xrange [0:0.6]
set yrange [0:10]
set y2range [20:0]
set key top left
set lmargin 7
set label 1 "profile of the stamp" at 0.05,9.1
unset label 1
plot ARG4 using "r_in":(10 - 0.3*column("gap_1e-3_in")) with lines lt 8 title "edge of the stamp (not to scale)", \
     ARG3 using "r_in":"p_1e4_psi" with lines lt 1 title "closed form", \
     ARG1 using "r_in":"p_1e4_psi" with points lt 3 ps 0.8 title "COUNTAXI", \
     ARG5 using "r_in":"p_1e4_psi" with lines lt 2 title "sharp punch"
set xrange [0.48:0.52]
set xtics 0.01
set yrange [0:10]
unset key
set title "the edge"
set ylabel ""
plot ARG3 using "r_in":"p_1e4_psi" with lines lt 1, \
     ARG1 using "r_in":"p_1e4_psi" with points lt 3, \
     ARG5 using "r_in":"p_1e4_psi" with lines lt 2
unset multiplot
