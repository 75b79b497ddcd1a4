load "style.gp"
set output ARG2
set logscale x
set xrange [20:5000]
set yrange [0:1.45]
set xlabel "wavelength, ft"
set ylabel "gain"
set xtics (20, 50, 100, 150, 200, 500, 1000, 2000, 5000)
set key top right title "chosen: the paper prints none" left
set style arrow 1 nohead ls guide
plot ARG3 using "wavelength_ft":(0):(0):(1.1) with vectors arrowstyle 1, \
     ARG3 using ($0 == 0 ? 146 : NaN):(0.62):"what" with labels right, \
     ARG3 using ($0 == 1 ? 205 : NaN):(0.42):"what" with labels left, \
     ARG1 using "wavelength_ft":"chosen" with lines lt 1 title "1 − b⁴, mean over 151 ft", \
     ARG1 using "wavelength_ft":"two_stages" with lines lt 2 title "(1 − b⁴)²", \
     ARG1 using "wavelength_ft":"one_pass" with lines lt 3 title "1 − b, mean over 301 ft", \
     NaN with lines ls guide title "paper: limit at this speed"
