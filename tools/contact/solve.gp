# The answer of `contact solve`: pressures as a map, the edge of the contact around them. ARG4 names the units and axes.
load "style.gp"
set output ARG2
set terminal pngcairo size 1100,750
note(length, pressure, x, y) = (length_unit = length, pressure_unit = pressure, x_name = x, y_name = y, 1)
set xrange [-1:1]
set yrange [0:2]
set table $unused
plot ARG4 using (note(strcol("length"), strcol("pressure"), strcol("x"), strcol("y")))
unset table
set autoscale
set xlabel x_name . ", " . length_unit
set ylabel y_name . ", " . length_unit
set cblabel "pressure, " . pressure_unit
set cblabel offset 2
set rmargin 18
unset key
set grid noxtics noytics
stats ARG1 using 3 nooutput
set cbrange [0:STATS_max]
# True proportions unless the patch is too slender to show them.
stats ARG3 using 1 name "X" nooutput
stats ARG3 using 3 name "Y" nooutput
slender = (X_max - X_min) / (2 * Y_max)
if (slender > 0.25 && slender < 4) { set size ratio -1 }
plot ARG1 using 1:2:($3 > 0 ? $3 : NaN) with image, \
     ARG3 using 1:2 with lines lc rgb black lw 1.5 dt solid, \
     ARG3 using 1:3 with lines lc rgb black lw 1.5 dt solid
