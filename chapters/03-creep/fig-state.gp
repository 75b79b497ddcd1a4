load "style.gp"
set output ARG2
set terminal pngcairo size 900,370
set xlabel "largest friction coefficient µ_c, assumed"
set ylabel "area needed, over Hertz's"
set xrange [0.3:1]
set yrange [0.6:3.2]
unset key
set style fill transparent solid 0.18 noborder
set label "major axis along rolling" at 0.5,2.02 left tc rgb "#0072B2"
set label "major axis across" at 0.5,0.75 left tc rgb "#D55E00"
set label "bands: speeds within their printed 0.1 rpm" at 0.5,2.9 left
set arrow from 0.3,1 to 1,1 nohead ls guide
set label "Hertz's area" at 0.305,0.88 left tc rgb grey
plot ARG1 using "mu_c":"along_low":"along_high" with filledcurves lc rgb "#0072B2" title "along, rounding", \
     ARG1 using "mu_c":"across_low":"across_high" with filledcurves lc rgb "#D55E00" title "across, rounding", \
     ARG1 using "mu_c":"along" with lines lw 2 dt solid lc rgb "#0072B2" title "along, as printed", \
     ARG1 using "mu_c":"across" with lines lw 2 dt solid lc rgb "#D55E00" title "across, as printed"
