# alt: Six panels of the difference of our answers from CONTACT's in per cent against CONTACT's value: normal force, largest pressure, approach, contact area, longitudinal force and lateral force. Normal force, pressure and approach lie near zero, the forces within three per cent, and small areas within ten.
load "style.gp"
set output ARG2
set terminal pngcairo size 740,480 font "DejaVu Sans,11" enhanced background rgb "white"
set minussign
set multiplot layout 2,3
set logscale x
set format x "10^{%T}"
set xtics 100
set yrange [-11:11]
set ytics 5
unset key
do for [k=0:5] {
  set title (k==0 ? "normal force, N" : k==1 ? "largest pressure, MPa" : k==2 ? "approach, mm" : k==3 ? "contact area, mm²" : k==4 ? "longitudinal force, N" : "lateral force, N")
  if (k % 3 == 0) { set ylabel "difference, %" } else { unset ylabel }
  if (k > 2) { set xlabel "CONTACT" } else { unset xlabel }
  plot 0 with lines lt 1 lw 1, ARG1 using ($1==k ? $2 : 1/0):(100*($3/$2 - 1)) with points lt 2 ps 0.6
}
unset multiplot
