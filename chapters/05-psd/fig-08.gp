# alt: Six panels, one a zone: the spectrum of synthetic track over the printed random part, against wavenumber. Each is near one but for a peak at the rail's wavenumber, which is narrow in zones 7 and 13 and broad in zones 10, 2, 11 and 12; circles mark the printed height.
load "style.gp"
set terminal pngcairo size 1100,640 font "DejaVu Sans,12" enhanced background rgb "white"
set output ARG2
set logscale xy
set format y "%g"
set xrange [0.01:1.2]
set yrange [0.6:8]
set ytics (0.7, 1, 2, 5)
set xtics (0.01, 0.03, 0.1, 0.3, 1)
names = "7 10 2 11 12 13"
set key top right samplen 2.5 nobox noopaque Left reverse
set key off
set multiplot layout 2,3 margins 0.07,0.985,0.1,0.95 spacing 0.05,0.13
do for [z = 1:6] {
  set title sprintf("(%s) zone %s", substr("abcdef", z, z), word(names, z)) offset 0,-0.7
  if (z > 3) { set xlabel "wavenumber φ, cycle/m" }
  if (z % 3 == 1) { set ylabel "S_z / printed random part" offset 1 } else { unset ylabel }
  is(name) = name eq word(names, z)
  plot 1 with lines ls guide, \
       ARG1 using (is(strcol("zone")) ? column("phi_cycle_per_m") : NaN):"S_over_printed" with lines lc rgb blue lw 1.6 dt solid title (z == 6 ? "synthetic track" : ""), \
       ARG3 using (is(strcol("zone")) ? column("phi_cycle_per_m") : NaN):"fitted_over_printed" with lines lc rgb black lw 1.8 dt (12,4) title (z == 6 ? "two lines fitted" : ""), \
       ARG4 using (is(strcol("zone")) ? column("phi_c") : NaN):(0.6):(0):(0.15) with vectors filled lc rgb red lw 2 dt solid title (z == 6 ? "printed φ_c" : ""), \
       ARG4 using (is(strcol("zone")) ? column("phi_cycle_per_m") : NaN):"peak_over_printed" with points ls printed title (z == 6 ? "printed C_1" : "")
  if (z == 5) { set key on } else { set key off }
}
unset multiplot
