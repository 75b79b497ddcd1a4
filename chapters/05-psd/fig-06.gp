# alt: Five records of 130 m under each other: arches of 33 ft, a smooth wave of the same length,
# alt: arches of 39 ft, the sum of the last two with dips of uneven shape, and arches of 39 ft whose
# alt: dips follow a slow wave.
load "style.gp"
set terminal pngcairo size 1000,720
set output ARG2
unset key
set multiplot layout 5,1 margins 0.085,0.98,0.1,0.98 spacing 0,0.03
set format x ""
set xrange [0:130.8]
set yrange [-21:6]
set ytics 10
set ylabel "height, mm" offset 0.8
set label 1 "(a) height with old joints, 33-ft rails" at graph 0.012,0.13 left
plot ARG1 using "x_m":"old_mm" with lines lt 1
set label 1 "(b) what the reworked ballast keeps: the fundamental" at graph 0.012,0.13 left
plot ARG1 using "x_m":"fundamental_mm" with lines lt 1
set label 1 "(c) new joints, 39-ft rails" at graph 0.012,0.13 left
plot ARG1 using "x_m":"new_mm" with lines lt 1
set label 1 "(d) linear interaction: the sum" at graph 0.012,0.13 left
plot ARG1 using "x_m":"linear_mm" with lines lt 1
set label 1 "(e) nonlinear interaction: the product, and its envelope" at graph 0.2,0.13 left
set xlabel "distance, m"
set format x "%g"
plot ARG1 using "x_m":"nonlinear_mm" with lines lt 1, \
     ARG1 using "x_m":"envelope_mm" with lines lt 3
unset multiplot
