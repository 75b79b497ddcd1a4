# alt: Two bands that fall with the assumed largest friction. The band for the longer axis across lies lower and includes one, Hertz's area, from a largest friction of about one half on; the other comes close to one at large friction.
load "style.gp"
set output ARG2
set terminal pngcairo size 740,270 font "DejaVu Sans,12" enhanced background rgb "white"
set xlabel "largest friction coefficient µ_c, assumed"
set ylabel "area needed, over Hertz's"
set xrange [0.3:1]
set yrange [0.6:3.2]
unset key
set style fill transparent solid 0.18 noborder
set label "longer axis along rolling" at 0.52,2.2 left tc rgb blue
set label "longer axis across" at 0.5,0.78 left tc rgb "#BE5400"
set label "bands: speeds within their printed 0.1 rpm" at 0.5,2.9 left
set arrow from 0.3,1 to 1,1 nohead ls guide
set label "Hertz's area" at 0.305,0.88 left tc rgb "#606060"
plot ARG1 using "mu_c":"along_low":"along_high" with filledcurves lc rgb blue, \
     ARG1 using "mu_c":"across_low":"across_high" with filledcurves lc rgb red, \
     ARG1 using "mu_c":"along" with lines lw 2 dt solid lc rgb blue, \
     ARG1 using "mu_c":"across" with lines lw 2 dt solid lc rgb red
