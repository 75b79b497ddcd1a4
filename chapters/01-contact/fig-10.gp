# alt: The mesh of the contact seen from above, a half moon that ends just beyond the jump at x = 0, inside a larger closed curve.
load "style.gp"
set terminal pngcairo size 740,500 font "DejaVu Sans,12" enhanced background rgb "white"
set output ARG2
set minussign
unset key
set xlabel "x across the rail, in"
set ylabel "y along the rail, in"
set size ratio -1
set xrange [-0.78:0.2]
set yrange [-0.5:0.45]
set arrow from 0, graph 0 to 0, graph 1 nohead ls guide
set label "interpenetration\ncurve" at -0.77,0.425 textcolor rgb "#BE5400"
set label "crown" at -0.02,-0.47 right
set label "corner" at 0.02,-0.47 left
plot ARG1 using "x_in":"y_in":(0.5*column("dx_in")):(0.5*column("dy_in")) with boxxyerror fs empty lc rgb black lw 1, \
     ARG3 using "x_in":"y_in" with lines lt 3
