# alt: Two panels. Top: largest pressure against shift, lowest at no shift, and several times as much when the contact of the right wheel reaches the flange; CONTACT's points lie on the lines. Bottom: the differences from CONTACT, the full theory within two per cent, strips and Hertz within five.
load "style.gp"
set output ARG2
set terminal pngcairo size 740,560 font "DejaVu Sans,12" enhanced background rgb "white"
set minussign
set multiplot
set lmargin at screen 0.14
set rmargin at screen 0.98
set tmargin at screen 0.98
set bmargin at screen 0.5
set ylabel "largest pressure, MPa"
set xrange [-10:10]
set yrange [0:2800]
set format x ""
set key left top reverse Left nobox
plot ARG3 using 1:2 with points lt 2 title "CONTACT", ARG1 using "y_mm":"full" with lines lt 1 title "full theory", \
     ARG1 using "y_mm":"strips" with lines lt 3 title "strips", ARG1 using "y_mm":"hertz" with lines lt 4 title "Hertz"
unset key
set tmargin at screen 0.46
set bmargin at screen 0.115
set format x "%g"
set xlabel "shift towards the wheel's flange, mm (left wheel negative)"
set ylabel "difference, %"
set yrange [-6:6]
plot ARG1 using "y_mm":"full_off" with linespoints lt 1 pt 7 ps 0.6, ARG1 using "y_mm":"strips_off" with linespoints lt 3 pt 7 ps 0.6, ARG1 using "y_mm":"hertz_off" with linespoints lt 4 pt 7 ps 0.6
unset multiplot
