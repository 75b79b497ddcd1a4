# alt: Four curves of friction against creep. All rise from zero and level off, the one at 500 lbf highest and the one at 2500 lbf lowest at large creep.
load "style.gp"
set output ARG2
set terminal pngcairo size 740,330 font "DejaVu Sans,12" enhanced background rgb "white"
set xlabel "creep ξ"
set ylabel "friction coefficient µ = T/N"
set xrange [0:0.02]
set yrange [0:0.65]
set rmargin 10
unset key
stats ARG1 using 2 every ::200::200 name "A" nooutput
stats ARG1 using 3 every ::200::200 name "B" nooutput
stats ARG1 using 4 every ::200::200 name "C" nooutput
stats ARG1 using 5 every ::200::200 name "D" nooutput
set label "500 lbf" at 0.0203,A_max left tc rgb blue
set label "1000 lbf" at 0.0203,B_max+0.010 left tc rgb "#BE5400"
set label "1500 lbf" at 0.0203,C_max-0.002 left tc rgb "#007A5A"
set label "2500 lbf" at 0.0203,D_max-0.012 left tc rgb "#97567A"
set label "from synthetic points" at graph 0.03, 0.95 tc rgb "#BE5400"
plot for [k=2:5] ARG1 using 1:k with lines lt k
