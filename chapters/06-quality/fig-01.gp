load "style.gp"
set terminal pngcairo size 1000,580
set output ARG2
unset border; unset tics; unset grid; unset key
set xrange [-4.2:4.2]
set yrange [-1.0:4.6]
set size ratio -1
set object 1 rectangle from -1.4,2.85 to 1.4,3.75 fc rgb light fs solid border lc rgb black lw 2
set label "body M" at 0,3.3 center font ",18"
set object 2 circle at 0,0.72 size 0.72 fc rgb "#F2F2F2" fs solid border lc rgb black lw 2
set label "wheel m" at 0,0.72 center font ",16"
set arrow from -0.9,1.55 to 0.9,1.55 nohead lw 3
set arrow from 0,0.72 to 0,0.72 nohead
set arrow from 0,1.44 to 0,1.55 nohead lw 3
set label "k" at -1.0,2.2 font ",18"
set label "b" at 0.95,2.2 font ",18"
set arrow from 0.5,1.55 to 0.5,2.05 nohead lw 2.4
set arrow from 0.28,2.5 to 0.28,2.05 nohead lw 2.4
set arrow from 0.72,2.5 to 0.72,2.05 nohead lw 2.4
set arrow from 0.28,2.05 to 0.72,2.05 nohead lw 2.4
set arrow from 0.34,2.3 to 0.66,2.3 nohead lw 2.4
set arrow from 0.5,2.3 to 0.5,2.85 nohead lw 2.4
set arrow from 2.2,3.3 to 2.2,4.1 filled size 0.12,20 lw 2 lc rgb blue
set label "y  motion of the body" at 2.35,3.7 textcolor rgb blue
set arrow from 2.2,1.55 to 2.2,2.75 heads filled size 0.12,20 lw 2 lc rgb red
set label "x = y − z  stroke" at 2.35,2.15 textcolor rgb red
set arrow from 2.2,0.3 to 2.2,1.1 filled size 0.12,20 lw 2 lc rgb green
set label "z  track under the wheel" at 2.35,0.75 textcolor rgb green
set arrow from 0,-0.95 to 0,-0.06 filled size 0.12,20 lw 2.4 lc rgb purple
set label "g  wheel force, dynamic part" at 0.15,-0.8 textcolor rgb purple
set arrow from -3.9,0.95 to -2.6,0.95 filled size 0.12,20 lw 2
set label "speed v" at -3.8,1.2
plot ARG1 using "x":"z" with lines lt 1 lw 3, ARG3 using "x":"z" with lines lt 1 lw 2.4
