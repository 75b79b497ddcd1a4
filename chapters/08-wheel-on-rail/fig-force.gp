# alt: Force along the track against shift. The full theory's line goes through CONTACT's points; strips and Hertz agree with each other and miss the points at no shift and on the flange.
load "style.gp"
set output ARG2
set terminal pngcairo size 740,400 font "DejaVu Sans,12" enhanced background rgb "white"
set xlabel "shift towards the wheel's flange, mm (left wheel negative)"
set ylabel "force along the track, N"
set xrange [-10:10]
set yrange [-2300:2500]
unset key
set label "■ CONTACT" at 1.4,2200 tc rgb blue
set label "full theory" at 1.4,1850
set arrow from 1.2,1850 to -6.6,1640 nohead lw 1
set label "strips" at 1.4,1200 tc rgb "#BE5400"
set arrow from 1.2,1150 to 0.1,310 nohead lw 1 lc rgb "#BE5400"
set label "Hertz" at 1.4,800 tc rgb "#007A5A"
set arrow from 1.2,780 to 0.1,540 nohead lw 1 lc rgb "#007A5A"
plot ARG3 using 1:2 with points lt 2, ARG1 using 1:2 with lines lt 1, ARG1 using 1:3 with lines lt 3, ARG1 using 1:4 with lines lt 4
