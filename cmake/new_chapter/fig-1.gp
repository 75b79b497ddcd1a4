load "style.gp"
set output ARG2
set xlabel "side, m"
set ylabel "area, m^2"
plot ARG1 using "side_m":"area_m2" title "equation (1)" with lines
