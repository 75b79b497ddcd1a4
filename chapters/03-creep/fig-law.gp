# alt: Creep against contact area, both over those of the new wheel. The law falls as one over the area; the three curves of a profile that wears flat lie close together and fall less, so that their product with the area has risen by a fifth where the area has grown by half.
load "style.gp"
set output ARG2
set terminal pngcairo size 1100,310 font "DejaVu Sans,13" enhanced background rgb "white"
set multiplot layout 1,2
unset key
set xlabel "contact area over that of the new wheel"
set ylabel "creep over the new wheel's"
set xrange [1:1.46]
set yrange [0.66:1]
set rmargin 3
set label 1 "profile wears flat" at 1.22,0.945 left
set label 2 "creep × area constant" at 1.02,0.74 left tc rgb "#606060"
plot ARG1 using "area":"creep_constant" with lines lt 8 lw 2.4, \
     ARG1 using "area":"creep_25" with lines lt 2, \
     ARG1 using "area":"creep_50" with lines lt 1, \
     ARG1 using "area":"creep_80" with lines lt 3
set ylabel "rise of creep × area, %"
set yrange [-1:21]
set rmargin 9
stats ARG1 using (100*(column("area")*column("creep_25")-1)) name "A" nooutput
stats ARG1 using (100*(column("area")*column("creep_80")-1)) name "C" nooutput
set label 1 "f = 0.25" at 1.463,(A_max+C_max)/2+1.9 left tc rgb blue
set label 2 "f = 0.5" at 1.463,(A_max+C_max)/2 left tc rgb black
set label 3 "f = 0.8" at 1.463,(A_max+C_max)/2-1.9 left tc rgb "#BE5400"
set label 4 "the law" at 1.3,1.6 left tc rgb "#606060"
plot ARG1 using "area":(100*(column("area")*column("creep_constant")-1)) with lines lt 8 lw 2.4, \
     ARG1 using "area":(100*(column("area")*column("creep_25")-1)) with lines lt 2, \
     ARG1 using "area":(100*(column("area")*column("creep_50")-1)) with lines lt 1, \
     ARG1 using "area":(100*(column("area")*column("creep_80")-1)) with lines lt 3
unset multiplot
