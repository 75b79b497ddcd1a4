# alt: Force against time after the joint. It jumps to the peak P1, swings with a period near 1 ms
# alt: about a slower rise and fades; the running mean has a flat maximum, P2, near 9 ms. With more
# alt: damping the swings die within 3 ms.
load "style.gp"
set output ARG2
set style textbox opaque noborder margins 0.3,0.3
set xlabel "time after the joint, ms"
set ylabel "wheel/rail force, kN"
set xrange [-4:20]
set yrange [60:225]
set label "P_0" at -3.8,128
set arrow from -4,122.33 to 20,122.33 nohead ls guide
plot ARG1 using 1:2 with lines lt 1 title "force, ζ = 0.05 between rail and tie", \
     ARG1 using 1:3 with lines lt 3 title "its running mean", \
     ARG4 using 1:2 with lines lt 7 title "force with more damping, ζ = 0.3", \
     ARG3 using 1:2 with points ls other, \
     ARG3 using (strcol(3) eq "P2" ? NaN : $1):2:3 with labels boxed offset 0,1 tc rgb green, \
     ARG3 using (strcol(3) eq "P2" ? $1 + 1.4 : NaN):($2 + 27):(-1.3):(-25) with vectors filled size 0.25,20 lw 1.2 lc rgb green, \
     ARG3 using (strcol(3) eq "P2" ? $1 + 1.6 : NaN):($2 + 33):3 with labels tc rgb green
