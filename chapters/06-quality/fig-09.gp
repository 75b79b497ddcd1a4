load "style.gp"
set output ARG2
set xrange [-1.5:1.5]
set yrange [0:6.2]
set key top left title "reconstructed"
set xlabel "descriptor"
set ylabel "density"
plot ARG1 using "p":"histogram" with lines lt 1 title "descriptor", \
     ARG1 using "p":"risk" with lines lt 3 title "strength of the vehicle", \
     ARG3 using "p":"height" with impulses ls guide lw 2 notitle, \
     ARG3 using "p":(column("height")+0.2):"name" with labels notitle
