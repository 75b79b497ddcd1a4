load "style.gp"
set output ARG2
set logscale xy
set format y "10^{%T}"
set xrange [0.005:2]
set xlabel "wavenumber, cycle/m"
set ylabel "S of the profile, m^2/(cycle/m), one-sided"
references = 0
behind = ARG1
if (ARGC > 2) {
  behind = ARG3
  stats behind using 1:2 nooutput
  references = STATS_blocks
  set tmargin 6
  set key above horizontal maxrows 4
}
plot ARG1 using "phi_cycle_per_m":"S_m2_per_cycle_per_m" with lines lc rgb blue lw 1.2 title "measured", \
     ARG1 using "phi_cycle_per_m":"fitted" with lines lt 1 title "fitted random part", \
     ARG1 using "phi_cycle_per_m":"A_line" with lines ls guide title "A/φ^2", \
     for [i=0:references-1] behind using 1:2 index i with lines lt i+3 title columnheader(3)
