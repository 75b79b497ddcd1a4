# alt: Two curves of the gap across the rail. The undeformed gap is a parabola that is negative between P' and Q'; the deformed gap is zero between P and Q, closer to the middle, and positive outside.
load "style.gp"
set terminal pngcairo size 740,330 font "DejaVu Sans,12" enhanced background rgb "white"
set output ARG2
unset key
set xlabel "x across the rail, in"
set ylabel "gap between the bodies, 10^{-6} in"
set xrange [-0.26:0.26]
set yrange [-450:270]
set arrow from graph 0, first 0 to graph 1, first 0 nohead ls guide
set label "undeformed,\ntogether by δ" at 0.155,-330 left textcolor rgb blue
set label "deformed: zero in the contact" at 0,90 center
beside(name) = strcol("label") eq name
plot ARG1 using "x_in":"before_microinch" with lines lt 2, \
     ARG1 using "x_in":"after_microinch" with lines lt 1, \
     ARG3 using "x_in":"z_microinch" with points pt 7 ps 1.4 lc rgb red, \
     "" using "x_in":"z_microinch":(beside("Q'") ? strcol("label") : "") with labels left offset 0.6,-0.9, \
     "" using "x_in":"z_microinch":(beside("P'") ? strcol("label") : "") with labels right offset -0.6,-0.9, \
     "" using "x_in":"z_microinch":(beside("P") || beside("Q") ? strcol("label") : "") with labels offset 0,-1
