load "style.gp"
set output ARG2
set terminal pngcairo size 1200,650
set logscale xy
set xlabel "speed, mph"
set ylabel "RMS error of the 62-ft chord, mm"
set xrange [0.45:130]
set yrange [1e-4:200]
set xtics (0.5, 1, 2, 5, 10, 20, 50, 100)
set format y "10^{%T}"
set arrow from 5,graph 0 to 5,graph 1 nohead ls guide
set arrow from 15,graph 0 to 15,graph 1 nohead ls guide
set label "5 mph" at 5.15,1.8e-4 tc rgb "#606060"
set label "15 mph" at 15.4,1.8e-4 tc rgb "#606060"
set rmargin 30
set key outside right center nobox
set title "synthetic track, chosen corners and sensors" font ",12" offset 0,-0.6
plot ARG1 using 1:"ideal-1.0_mm" with lines lt 1 title "ideal, 1 Hz", \
     ARG1 using 1:"12-bit_mm" with lines lt 2 title "12 bits, 1 Hz", \
     ARG1 using 1:"noise_mm" with lines lt 3 title "noise, 1 Hz", \
     ARG1 using 1:"displacement_mm" with lines lt 6 title "height steps of 0.1 mm", \
     ARG1 using 1:"ideal-0.1_mm" with lines lt 5 title "ideal, 0.1 Hz", \
     ARG1 using 1:"12-bit-0.1_mm" with lines lt 7 title "12 bits, 0.1 Hz"
