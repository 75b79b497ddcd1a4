# alt: Largest pressure against shift. It is lowest at no shift, grows slowly on the left wheel, and on the right wheel jumps to several times as much when the contact reaches the flange; CONTACT's points lie on the lines.
load "style.gp"
set output ARG2
set terminal pngcairo size 740,350 font "DejaVu Sans,12" enhanced background rgb "white"
set xlabel "shift towards the wheel's flange, mm (left wheel negative)"
set ylabel "largest pressure, MPa"
set xrange [-10:10]
set yrange [0:2800]
unset key
set label "■ CONTACT" at -9.5,2500 tc rgb blue
set label "full theory (line below the others)" at -9.5,2200
set label "strips" at -9.5,1900 tc rgb "#BE5400"
set label "Hertz" at -9.5,1600 tc rgb "#007A5A"
plot ARG3 using 1:2 with points lt 2, ARG1 using 1:2 with lines lt 1, ARG1 using 1:3 with lines lt 3, ARG1 using 1:4 with lines lt 4
