# alt: Above, a bell curve of the descriptor about 0 with thresholds T1 at plus and minus 0.5 and T2 beyond 0.7, and two narrow bell curves of the strength about plus and minus 1. Below, the product of the histogram and the risk: two small humps near plus and minus 0.9.
load "style.gp"
set terminal pngcairo size 740,390 font "DejaVu Sans,11"
set output ARG2
unset key
set multiplot
set lmargin 11
set rmargin 2
set xrange [-1.5:1.5]
set xtics 0.5
set format x ""
set tmargin at screen 0.97
set bmargin at screen 0.48
set yrange [0:4.8]
set ytics 1
set ylabel "density"
set label 1 "descriptor" at 0.2,1.5 font ",11"
set label 2 "strength of\nthe vehicle" at 1.15,3.2 font ",11" textcolor rgb "#A84300"
plot ARG1 using "p":"histogram" with lines lt 1, \
     ARG1 using "p":"risk" with lines lt 3 dt 1, \
     ARG3 using "p":"height" with impulses ls guide lw 2, \
     ARG3 using "p":(column("height")+0.25):"name" with labels font ",11"
unset label 1; unset label 2
set format x "%g"
set tmargin at screen 0.42
set bmargin at screen 0.165
set yrange [0:0.4]
set ytics 0.1
set xlabel "descriptor p"
set ylabel "risk, ×10⁻³"
plot ARG1 using "p":(1000 * column("product")) with filledcurves y=0 fc rgb "#A84300" fs transparent solid 0.35 noborder, \
     ARG1 using "p":(1000 * column("product")) with lines lt 3 dt 1 lw 1.4
unset multiplot
