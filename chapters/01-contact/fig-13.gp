load "style.gp"
set output ARG2
set terminal pngcairo size 1300,520
set xlabel "x along the axis, in"
set ylabel "y, in"
set xrange [-0.82:0.82]
set yrange [-0.0125:0.0155]
set key top right horizontal nobox
set grid noxtics noytics
plot ARG3 using "x_in":"y_in":(0.5*column("dx_in")):(0.5*column("dy_in")) with boxxyerror fs empty lc rgb grey lw 1 title "final mesh of COUNTACT-2", \
     ARG1 using "x_in":"y_in" with lines lt 2 dt solid title "edge by CG-FFT"
