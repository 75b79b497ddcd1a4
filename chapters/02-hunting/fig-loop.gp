load "style.gp"
set terminal pngcairo size 900,430 font "DejaVu Sans,14" enhanced background rgb "white"
set output ARG2
set xlabel "speed V, ft/s"
set ylabel "largest wheelset amplitude A, in"
set xrange [90:250]
set yrange [0:0.8]
set key at graph 0.98,0.4 right top font ",12" samplen 2
set label 2 "did not converge" at 222,0.775 center tc rgb grey
plot ARG4 using 2:1 with lines lt 8 dt solid title "first family, by continuation", \
     ARG5 using 2:1 with lines lt 8 dt (6,4) title "second family, by continuation", \
     ARG1 using 2:1 with points pt 7 ps 1.1 lc rgb black title "least damped mode (the paper's)", \
     ARG3 using 2:1 with points pt 4 ps 1.3 lc rgb blue title "next least damped (its footnote)", \
     ARG1 using (210):3 with points pt 7 ps 0.8 lc rgb black, \
     ARG3 using (222):3 with points pt 4 ps 0.9 lc rgb blue
