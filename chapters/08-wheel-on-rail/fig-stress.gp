# alt: Von Mises stress over the largest pressure against depth. On the tread it has its maximum about a millimetre down; on the flange it is largest at the surface when the wheel slides, with a second maximum just below it.
load "style.gp"
set output ARG2
set terminal pngcairo size 740,380 font "DejaVu Sans,12" enhanced background rgb "white"
set xlabel "depth, mm"
set ylabel "von Mises stress over the largest pressure"
set xrange [0:3.7]
set yrange [0:0.75]
unset key
set label "3 mm, on the tread" at 2.2,0.62
set label "8 mm, on the flange" at 0.75,0.40 left tc rgb "#BE5400"
set label "dashed: the pressure alone" at graph 0.97,0.93 right tc rgb "#606060"
plot ARG1 using 1:2 every :::0::0 with lines lt 1, \
     ARG1 using 1:3 every :::0::0 with lines lt 1 dt (5,4) lw 1.8, \
     ARG1 using 1:2 every :::1::1 with lines lt 3 dt solid, \
     ARG1 using 1:3 every :::1::1 with lines lt 3 dt (5,4) lw 1.8
