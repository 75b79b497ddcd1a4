# The answer of `wheelrail contact`: both sections with their patches, and the pressures from above.
load "style.gp"
set terminal pngcairo size 1080,860
set output ARG2
set multiplot layout 2,2
set xlabel "to the right, mm"
set size ratio -1
set lmargin 9
set rmargin 9
unset key
name(side) = side == 1 ? "left" : "right"
do for [side = 1:2] {
  set autoscale
  stats ARG3 using ($1 == side ? $2 : NaN) name "Y" nooutput
  stats ARG3 using ($1 == side ? $3 : NaN) name "Z" nooutput
  set title name(side) . ": wheel (dashed), rail, patches and normals"
  set ylabel "down, mm"
  set xrange [Y_mean - 40 : Y_mean + 40]
  set yrange [Z_mean + 25 : Z_mean - 25]
  plot ARG1 using ($1 == 2 * side - 1 ? $2 : NaN):3 with lines lt 1, \
       ARG1 using ($1 == 2 * side ? $2 : NaN):3 with lines lt 2, \
       ARG3 using ($1 == side ? $2 - $4 : NaN):($3 - $5):(2 * $4):(2 * $5) with vectors nohead lc rgb red lw 6 dt solid, \
       ARG3 using ($1 == side ? $2 : NaN):3:(12 * $6):(12 * $7) with vectors lc rgb red lw 2 dt solid, \
       ARG3 using ($1 == side ? $2 + 12 * $6 : NaN):($3 + 12 * $7 + 3):(sprintf("%.1f°", $8)) with labels textcolor rgb red
}
set autoscale
set cbrange [0:*]
set cblabel "pressure, MPa" offset 1
set rmargin 14
set ylabel "along the track, mm"
set xtics rotate by 45 right
do for [side = 1:2] {
  # True proportions unless the patch is too slender to show them.
  stats ARG4 using ($1 == side ? $2 : NaN) name "Y" nooutput
  stats ARG4 using ($1 == side ? $3 : NaN) name "X" nooutput
  if (Y_max - Y_min > 0.25 * (X_max - X_min)) { set size ratio -1 } else { set size noratio }
  set title name(side) . ": pressure from above"
  plot ARG4 using ($1 == side ? $2 : NaN):3:4:5:6 with boxxyerror lc palette
}
unset multiplot
