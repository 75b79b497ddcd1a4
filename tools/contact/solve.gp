# The answer of `contact solve`: pressures as a map, the edge of the contact around them. Units stand in the headers.
load "style.gp"
set output ARG2
set terminal pngcairo size 1100,750
header = system("head -1 '" . ARG1 . "'")
comma = strstrt(header, ",")
first = substr(header, 1, comma - 1)
rest = substr(header, comma + 1, strlen(header))
third = substr(rest, strstrt(rest, ",") + 1, strlen(rest))
length_unit = substr(first, 3, strlen(first))
pressure_unit = substr(third, 3, strlen(third))
set xlabel "x across the rail, " . length_unit
set ylabel "y along the rail, " . length_unit
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
