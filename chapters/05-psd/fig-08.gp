load "style.gp"
set terminal pngcairo size 1300,900
set output ARG2
set logscale xy
set format y "10^{%T}"
set xrange [0.01:1.2]
set yrange [1e-10:2e-2]
set ytics 1e-10, 100, 1
set xtics (0.01, 0.03, 0.1, 0.3, 1)
names = "7 10 2 11 12 13"
set key bottom left font ",12" samplen 2.5 nobox noopaque Left reverse
set multiplot layout 2,3 margins 0.09,0.98,0.09,0.95 spacing 0.07,0.12
do for [z = 1:6] {
  set title sprintf("(%s) zone %s", substr("abcdef", z, z), word(names, z)) offset 0,-0.7
  if (z > 3) { set xlabel "wavenumber, cycle/m" }
  if (z % 3 == 1) { set ylabel "S, m^2/(cycle/m)" offset 1 } else { unset ylabel }
  is(name) = name eq word(names, z)
  plot ARG1 using (is(strcol("zone")) ? column("phi_cycle_per_m") : NaN):"S_m2_per_cycle_per_m" with lines lc rgb blue lw 1.6 title (z == 1 ? "synthetic track" : ""), \
       ARG3 using (is(strcol("zone")) ? column("phi_cycle_per_m") : NaN):"S_printed" with lines lc rgb red lw 2.2 dt (14,5) title (z == 1 ? "printed A, φ_c" : ""), \
       ARG3 using (is(strcol("zone")) ? column("phi_cycle_per_m") : NaN):"S_fitted" with lines lc rgb black lw 1.4 title (z == 1 ? "fitted" : ""), \
       ARG4 using (is(strcol("zone")) ? column("phi_cycle_per_m") : NaN):"S_peak" with points ls printed title (z == 1 ? "printed C_1 above them" : ""), \
       ARG4 using (is(strcol("zone")) ? column("phi_c") : NaN):"S_corner" with points pt 2 ps 1.6 lw 2.4 lc rgb red title (z == 1 ? "printed φ_c" : "")
  set key off
}
unset multiplot
