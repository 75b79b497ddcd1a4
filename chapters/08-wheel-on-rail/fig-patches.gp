# alt: Five patches beside each other. At no shift a wide, long one of odd shape, far from Hertz's ellipse; then smaller and nearly elliptical ones; on the flange a sliver that is many times longer than wide.
load "style.gp"
set output ARG2
set terminal pngcairo size 1100,360 font "DejaVu Sans,13" enhanced background rgb "white"
set minussign
set multiplot
unset key
unset grid
set size ratio -1
set border 3
do for [k=0:4] {
  shift = 2*k
  left = 0.062+0.19*k
  set lmargin at screen left
  set rmargin at screen left+0.16
  set bmargin at screen 0.47
  set tmargin at screen 0.95
  set xrange [*:*]
  set yrange [*:*]
  stats ARG1 using (column("shift_mm") == shift ? column("p_MPa") : NaN) name "p" nooutput
  stats ARG4 using (column("shift_mm") == shift ? column("dy_mm") : NaN) name "dy" nooutput
  stats ARG4 using (column("shift_mm") == shift ? column("dx_mm") : NaN) name "dx" nooutput
  set cbrange [0:p_max]
  set xrange [-12.5:8.5]
  set yrange [-8:8]
  set xtics nomirror 5
  set ytics nomirror 5
  set xlabel "across, mm" offset 0,0.5
  if (k == 0) { set ylabel "along, mm" } else { unset ylabel }
  set label 1 sprintf("shift %d mm", shift) at graph 0.5, 1.06 center
  set colorbox horizontal user origin left+0.01,0.21 size 0.14,0.04
  set cbtics (0, p_max) format "%.0f"
  if (k == 2) { set cblabel "pressure, MPa" offset 0,0.2 } else { set cblabel " " offset 0,0.2 }
  plot ARG1 using (column("shift_mm") == shift ? column("across_mm") : NaN):"along_mm":(0.5*dy_max):(0.5*dx_max):"p_MPa" with boxxyerror fs solid 1 noborder fc palette, \
       ARG3 using (column("shift_mm") == shift ? column("across_mm") : NaN):"along_mm" with lines lw 1.6 dt (5,4) lc rgb red
}
unset multiplot
