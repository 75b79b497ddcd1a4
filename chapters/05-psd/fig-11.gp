# alt: Roughness against dip on logarithmic axes. Six limits of classes are level on the left and
# alt: fall steeply on the right. Twelve zones lie near a rising dashed line, most between the
# alt: limits of classes 5 and 6, zone 12 at that of class 3; zone 13 lies far below.
load "style.gp"
set output ARG2
set logscale xy
set format y "10^{%T}"
set xrange [0.5:60]
set yrange [8e-9:1.5e-5]
set xlabel "joint dip B (printed convention), mm"
set ylabel "roughness A, m²·cycle/m"
set key at screen 0.53, screen 0.99 center top horizontal maxrows 2 nobox
set tmargin 4.5
set label "random part decides" at 0.62, 6e-7 tc rgb "#606060"
set label "joints decide" at 7, 2.6e-8 tc rgb "#606060"
plot ARG1 using "B_mm":"A_m2_cycle_per_m" with lines lt 2 dt solid lw 2 title "limits of the classes, (10)", \
     ARG4 using "B_mm":"A_m2_cycle_per_m" with lines ls guide title "both parts equal, kA = 4B²", \
     ARG3 using (column("jointed") == 1 ? column("B_mm") : NaN):"A_m2_cycle_per_m" with points lt 3 title "zones, jointed", \
     ARG3 using (column("jointed") == 0 ? column("B_mm") : NaN):"A_m2_cycle_per_m" with points pt 6 ps 1.5 lw 2.2 lc rgb green title "zones, welded", \
     for [n = 1:13] ARG3 using (strcol("zone") eq sprintf("%d", n) ? column("B_mm") : NaN):"A_m2_cycle_per_m":"zone" \
       with labels offset (n == 2 ? -1.3 : n == 1 ? 0 : 1.3),(n == 1 ? -0.9 : n == 3 ? -0.2 : 0.6) font ",13" notitle, \
     ARG5 using "B_mm":"A_m2_cycle_per_m":(column("class") == 6 ? "class 6" : "") with labels right offset -1.4,0 tc rgb blue font ",13" notitle, \
     ARG5 using "B_mm":"A_m2_cycle_per_m":(column("class") == 6 ? "" : sprintf(column("class") == 5 ? "class %d" : "%d", column("class"))) with labels right offset -0.6,0 tc rgb blue font ",13" notitle
