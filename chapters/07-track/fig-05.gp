# alt: Deflection at a point while two trucks pass: two dents of 6 mm. At 60 mph it is the static
# alt: one; at 250 mph the dents are a little deeper and their sides steeper, and small waves follow.
load "style.gp"
set terminal pngcairo size 1000,420
set output ARG2
set xlabel "distance travelled since the first wheel passed the point, m"
set ylabel "deflection, mm (down)"
set yrange [7.5:-1]
set xrange [-5:27]
set xzeroaxis ls guide
set key at 12.0,2.6 right top samplen 2 font ",13"
do for [x in "0 1.778 15 16.778"] { set arrow from real(x), graph 0.97 to real(x), first 0 lc rgb red lw 2 }
plot ARG1 using 1:2 with lines lt 1 title "standing still", \
     ARG1 using 1:3 with lines lt 2 title "60 mph", \
     ARG1 using 1:4 with lines lt 3 title "250 mph"
