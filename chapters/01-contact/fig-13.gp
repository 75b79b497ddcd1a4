# alt: A long thin mesh of the roller's contact, 1.6 in long and 0.02 in wide, slightly wider beyond the ends of the straight part, with a line around it.
load "style.gp"
set terminal pngcairo size 740,280 font "DejaVu Sans,12" enhanced background rgb "white"
set output ARG2
set minussign
set xlabel "x along the axis, in"
set ylabel "y, in"
set xrange [-0.82:0.82]
set yrange [-0.0115:0.0115]
set key above horizontal nobox
set grid noxtics noytics
plot ARG3 using "x_in":"y_in":(0.5*column("dx_in")):(0.5*column("dy_in")) with boxxyerror fs empty lc rgb grey lw 1 title "last mesh of COUNTACT-2", \
     ARG1 using "x_in":"y_in" with lines lt 2 dt solid title "edge by CG-FFT"
