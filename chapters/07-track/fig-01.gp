# alt: The shape of a rail under a load: deepest under it, zero at a distance of 3 pi/4 over beta to
# alt: each side and lifted slightly beyond. Squares of a Fourier integral lie on it.
load "style.gp"
set terminal pngcairo size 1000,460
set output ARG2
set xlabel "distance from the load, βX"
set ylabel "deflection over that under the load, a"
set xrange [-4:4]
set yrange [1.1:-0.2]
set key bottom right
set arrow from graph 0, first 0 to graph 1, first 0 nohead ls guide
set label "zero at 3π/4" at 2.36,-0.165 center
set arrow from 2.356,-0.125 to 2.356,-0.01 lw 1.2
plot ARG1 using "beta_x":"a" with lines lt 1 title "equation (1)", \
     ARG3 using "beta_x":"a" with points ls other title "Fourier integral"
