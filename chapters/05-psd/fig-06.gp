load "style.gp"
set terminal pngcairo size 1000,840
set output ARG2
unset key
set multiplot layout 5,1 margins 0.08,0.98,0.09,0.95 spacing 0,0.06
set format x ""
set xrange [0:130.8]
set yrange [-21:6]
set ytics 10
set ylabel "mm"
set title "(a) old joints, 33-ft rails"
plot ARG1 using "x_m":"old_mm" with lines lt 1
set title "(b) what the reworked ballast keeps: the fundamental"
plot ARG1 using "x_m":"fundamental_mm" with lines lt 1
set title "(c) new joints, 39-ft rails"
plot ARG1 using "x_m":"new_mm" with lines lt 1
set title "(d) linear interaction: the sum"
plot ARG1 using "x_m":"linear_mm" with lines lt 1
set title "(e) nonlinear interaction: the product, and its envelope"
set xlabel "distance, m"
set format x "%g"
plot ARG1 using "x_m":"nonlinear_mm" with lines lt 1, \
     ARG1 using "x_m":"envelope_mm" with lines lt 3
unset multiplot
