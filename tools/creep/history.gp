load "style.gp"
set output ARG2
set xlabel "distance rolled, mm"
set ylabel "force of the wheel on the rail, kN"
set y2label "longitudinal creepage"
set key outside top center horizontal
set rmargin 12
set ytics nomirror
set y2tics
stats ARG1 using (1000*column("distance_m")) name "X" nooutput
stats ARG1 using (column("fx_N")/1000) name "FX" nooutput
stats ARG1 using (column("fy_N")/1000) name "FY" nooutput
stats ARG1 using "longitudinal" name "C" nooutput
low = FX_min < FY_min ? FX_min : FY_min
high = FX_max > FY_max ? FX_max : FY_max
size(x) = x == 0 ? 1e-3 : abs(x)
margin(from, to) = to > from ? 0.05*(to - from) : 0.1*size(from)
set xrange [X_min - (X_max > X_min ? 0 : 0.1*size(X_min)) : X_max + (X_max > X_min ? 0 : 0.1*size(X_min))]
set yrange [low - margin(low, high) : high + margin(low, high)]
set y2range [C_min - margin(C_min, C_max) : C_max + margin(C_min, C_max)]

rolled(x) = strcol("kind") eq "rolled" ? x : NaN
plot ARG1 using (1000*column("distance_m")):(column("fx_N")/1000) with lines lt 1 title "force along", \
     ARG1 using (1000*column("distance_m")):(column("fy_N")/1000) with lines lt 2 title "force across", \
     ARG1 using (1000*column("distance_m")):(rolled(column("longitudinal"))) axes x1y2 with lines lt 3 title "creepage"
