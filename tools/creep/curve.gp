load "style.gp"
set output ARG2
set xlabel "longitudinal creepage"
set ylabel "force of the wheel on the rail, kN"
set key bottom right
set xzeroaxis ls guide

# One point, or forces that are all alike, still need a range.
stats ARG1 using (column("longitudinal")) name "X" nooutput
stats ARG1 using (column("fx_N")/1000) name "FX" nooutput
stats ARG1 using (column("fy_N")/1000) name "FY" nooutput
low = FX_min < FY_min ? FX_min : FY_min
high = FX_max > FY_max ? FX_max : FY_max
size(x) = x == 0 ? 1e-3 : abs(x)
margin(from, to) = to > from ? 0.05*(to - from) : 0.1*size(from)
set xrange [X_min - (X_max > X_min ? 0 : 0.1*size(X_min)) : X_max + (X_max > X_min ? 0 : 0.1*size(X_min))]
set yrange [low - margin(low, high) : high + margin(low, high)]

plot ARG1 using "longitudinal":(column("fx_N")/1000) with linespoints lt 1 title "along, fx", \
     ARG1 using "longitudinal":(column("fy_N")/1000) with linespoints lt 2 title "across, fy"
