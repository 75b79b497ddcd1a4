# alt: Dents seen from the load. Left, without damping, they are symmetric and deepen and spread as
# alt: the speed nears the critical one. Right, with damping, the dent lags a little at half the
# alt: critical speed, and at twice that speed it lies wholly behind the load with short waves
# alt: ahead.
load "style.gp"
set terminal pngcairo size 1300,540
set output ARG2
set minussign
set multiplot layout 1,2
set yrange [*:*] reverse
set xzeroaxis ls guide
set xlabel "β(X − Vt), load at 0, running to the right"
set ylabel "deflection / static deflection (down)"
set rmargin 2
set arrow 1 from 0, graph 0.97 to 0, first 0 lc rgb red lw 2 front
set title "no damping"
set key bottom right
plot ARG1 using "s":"theta_0" with lines lt 1 title "θ = 0", \
     ARG1 using "s":"theta_05" with lines lt 2 title "θ = 0.5", \
     ARG1 using "s":"theta_08" with lines lt 3 title "θ = 0.8", \
     ARG1 using "s":"theta_095" with lines lt 4 title "θ = 0.95"
set title "ζ = 0.2"
unset ylabel
set xrange [-15:5]
set key bottom left
plot ARG3 using "s":"theta_05" with lines lt 2 title "θ = 0.5", \
     ARG3 using "s":"theta_1" with lines lt 6 title "θ = 1", \
     ARG3 using "s":"theta_2" with lines lt 5 title "θ = 2", \
     ARG4 using "s":"y" with points ls other ps 0.8 title "finite elements"
unset multiplot
