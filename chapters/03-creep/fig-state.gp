# alt: Two sets of three lines that fall with the assumed largest friction coefficient: the area as printed, and its limits by the rounding of the speeds. Those of the longer axis along rolling stay above one, Hertz's area; the lower limit of the longer axis across goes below one from a largest friction coefficient of about 0.45 on.
load "style.gp"
set output ARG2
set terminal pngcairo size 740,300 font "DejaVu Sans,12" enhanced background rgb "white"
set xlabel "largest friction coefficient µ_c, assumed"
set ylabel "area over Hertz's"
set xrange [0.302:1]
set yrange [0.6:3.2]
set rmargin 16
set tmargin 1
unset key
stats ARG1 using "along" name "A" nooutput
stats ARG1 using "along_low" name "AL" nooutput
stats ARG1 using "along_high" name "AH" nooutput
stats ARG1 using "across" name "C" nooutput
stats ARG1 using "across_low" name "CL" nooutput
stats ARG1 using "across_high" name "CH" nooutput
set label "along, highest" at 1.008,AH_min left tc rgb blue
set label "across, highest" at 1.008,CH_min+0.04 left tc rgb "#BE5400"
set label "along, as printed" at 1.008,A_min+0.03 left tc rgb blue
set label "across, as printed" at 1.008,C_min+0.14 left tc rgb "#BE5400"
set label "along, lowest" at 1.008,AL_min-0.06 left tc rgb blue
set label "across, lowest" at 1.008,CL_min left tc rgb "#BE5400"
set arrow from 0.302,1 to 1,1 nohead ls guide
set label "Hertz's area" at 0.32,0.86 left tc rgb "#606060"
plot ARG1 using "mu_c":"along_low" with lines lw 1.4 dt (8,6) lc rgb blue, \
     ARG1 using "mu_c":"along_high" with lines lw 1.4 dt (8,6) lc rgb blue, \
     ARG1 using "mu_c":"across_low" with lines lw 1.4 dt (8,6) lc rgb red, \
     ARG1 using "mu_c":"across_high" with lines lw 1.4 dt (8,6) lc rgb red, \
     ARG1 using "mu_c":"along" with lines lw 3 dt solid lc rgb blue, \
     ARG1 using "mu_c":"across" with lines lw 3 dt solid lc rgb red
