# alt: Four nested arches, the outermost the interpenetration curve, shrinking in three steps to Hertz's ellipse; the last mesh lies under it.
load "style.gp"
set terminal pngcairo size 740,400 font "DejaVu Sans,12" enhanced background rgb "white"
set output ARG2
unset key
set xlabel "x across the rail, in"
set ylabel "y along the rail, in"
set xrange [-0.21:0.21]
set yrange [0:0.125]
of(k) = column("iteration") == k ? column("x_in") : NaN
set label "first region" at 0.1,0.113 left textcolor rgb blue
set label "2nd" at 0,0.098 center textcolor rgb "#BE5400"
set label "3rd" at 0,0.0855 center textcolor rgb "#00835F"
set style textbox opaque noborder margins 0.5,0.3
set label "4th" at 0,0.0665 center boxed front
set label "Hertz's ellipse,\nthick" at -0.205,0.112 left textcolor rgb "#8A5F00"
set arrow from -0.176,0.1 to -0.0735,0.0687 nohead lc rgb "#8A5F00" lw 1 front
plot ARG3 using "x_in":"y_in":(0.5*column("dx_in")):(0.5*column("dy_in")) with boxxyerror fs empty lc rgb grey lw 0.8, \
     ARG4 using "x_in":"y_in" with lines lt 6, \
     ARG1 using (of(0)):"y_in" with lines lt 2, \
     "" using (of(1)):"y_in" with lines lt 3, \
     "" using (of(2)):"y_in" with lines lt 4, \
     "" using (of(3)):"y_in" with lines lt 1
