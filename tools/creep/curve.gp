load "style.gp"
set output ARG2
set xlabel "longitudinal creepage"
set ylabel "force of the wheel on the rail, kN"
set key bottom right
set xzeroaxis ls guide
set offsets 0, 0, graph 0.05, graph 0.05
plot ARG1 using "longitudinal":(column("fx_N")/1000) with linespoints lt 1 title "along, fx", \
     ARG1 using "longitudinal":(column("fy_N")/1000) with linespoints lt 2 title "across, fy"
