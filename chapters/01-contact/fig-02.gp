# alt: A half disc of boxes, nine columns of cells. Triangles mark a smaller arch inside it, circles the same arch at nine new columns between A and B.
load "style.gp"
set terminal pngcairo size 740,370 font "DejaVu Sans,12" enhanced background rgb "white"
set output ARG2
set xlabel "x across the rail, in"
set ylabel "y along the rail, in"
set xrange [-0.21:0.21]
set yrange [0:0.125]
set tmargin 3.4
set key above horizontal maxcols 2 nobox noopaque samplen 1.5 width 0
set label "A" at -0.187,0.012 right front
set label "B" at 0.187,0.012 left front
plot ARG1 using "x_in":"y_in":(0.5*column("dx_in")):(0.5*column("dy_in")) with boxxyerror fs empty lc rgb grey lw 1 title "cells of the first region", \
     ARG3 using "x_in":"y_in" with linespoints lt 1 lw 1.4 pt 9 ps 1.5 title "where the pressure is zero", \
     ARG4 using "x_in":"y_in" with points pt 6 ps 1.6 lw 2 lc rgb red title "heights of the new columns"
