# alt: Nine panels of our answers against CONTACT's, one each for normal force, largest pressure, approach, contact area, stick area, power of friction, the forces along and across, and the moment. Nearly all points lie on the line of equality.
load "style.gp"
set output ARG2
set terminal pngcairo size 740,700 font "DejaVu Sans,11" enhanced background rgb "white"
set multiplot layout 3,3
set logscale xy
set format xy "10^{%T}"
set xtics 100 
set ytics 100
unset key
set xlabel "CONTACT"
set ylabel "this program"
do for [k=0:8] {
  set title (k==0 ? "normal force, N" : k==1 ? "largest pressure, MPa" : k==2 ? "approach, mm" : k==3 ? "contact area, mm²" : k==4 ? "stick area, mm²" : k==5 ? "power of friction, W" : k==6 ? "force along, N" : k==7 ? "force across, N" : "moment, N mm")
  plot x with lines lt 1 lw 1, ARG1 using ($1==k ? $2 : 1/0):3 with points lt 2 ps 0.6
}
unset multiplot
