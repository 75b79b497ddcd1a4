# alt: Above, a wheel of mass m on a wavy rail carries a body of mass M by a spring k and a damper b, with a bump stop beside them. Arrows show
# alt: the height z of the track, the motion y of the body, the stroke x between them, the wheel force g and the speed v; the wave has length lambda and amplitude A.
# alt: Below, a record of 850 m of track with a hill of 60 mm, a bump of 16 mm and three waves of 12 mm, and under it its descriptor: near 0 on the hill, 0.9 on the bump and 0.8 on the waves.
load "style.gp"
set terminal pngcairo size 740,660 font "DejaVu Sans,11"
set output ARG2
unset key
set multiplot
set lmargin at screen 0
set rmargin at screen 1
set bmargin at screen 330.0/660
set tmargin at screen 1
set xrange [0:740]
set yrange [0:330]
unset border; unset tics; unset grid
px(x) = 230 + 46 * x
py(z) = 70 + 50 * z
set object 1 rectangle from px(-1.5),py(3.55) to px(1.5),py(4.45) fc rgb light fs solid border lc rgb black lw 1.6
set label 1 "body, mass M" at px(0),py(4.0) center
set object 2 circle at px(0),py(0.78) size 37 fc rgb "#F2F2F2" fs solid border lc rgb black lw 1.6
set label 2 "wheel\nmass m" at px(0),py(0.88) center font ",10"
set style arrow 1 nohead lw 2.2 lc rgb black
set arrow 1 from px(-1.1),py(1.9) to px(1.1),py(1.9) arrowstyle 1
set arrow 2 from px(0),py(1.56) to px(0),py(1.9) arrowstyle 1
set label 3 "k" at px(-1.16),py(2.7) right
set label 4 "b" at px(-0.22),py(2.72) right
# The damper.
set arrow 3 from px(0),py(1.9) to px(0),py(2.5) arrowstyle 1
set arrow 4 from px(-0.2),py(2.95) to px(-0.2),py(2.3) arrowstyle 1
set arrow 5 from px(0.2),py(2.95) to px(0.2),py(2.3) arrowstyle 1
set arrow 6 from px(-0.2),py(2.95) to px(0.2),py(2.95) arrowstyle 1
set arrow 7 from px(-0.15),py(2.5) to px(0.15),py(2.5) arrowstyle 1
set arrow 8 from px(0),py(2.95) to px(0),py(3.55) arrowstyle 1
# The stop: a block on the axle and one under the body, d apart.
set object 3 rectangle from px(0.7),py(1.9) to px(1.0),py(2.4) fc rgb "#B0653A" fs solid border lc rgb black
set object 4 rectangle from px(0.7),py(3.05) to px(1.0),py(3.55) fc rgb "#B0653A" fs solid border lc rgb black
set style arrow 2 heads filled size 7,20,60 lw 1.4 lc rgb "#7A4B00"
set arrow 9 from px(0.85),py(2.43) to px(0.85),py(3.02) arrowstyle 2
set label 5 "bump stop,\nmet at a stroke d" at px(1.15),py(2.86) textcolor rgb "#7A4B00"
set style arrow 3 filled size 8,20,60 lw 1.6
set arrow 10 from px(-2.6),py(3.55) to px(-2.6),py(4.45) arrowstyle 3 lc rgb blue
set label 6 "y, motion\nof the body" at px(-2.75),py(4.15) right textcolor rgb blue
set arrow 11 from px(-2.6),py(1.9) to px(-2.6),py(3.4) arrowstyle 2 lc rgb "#A84300"
set label 7 "x = y − z,\nthe stroke" at px(-2.75),py(2.8) right textcolor rgb "#A84300"
set arrow 12 from px(-2.6),py(0.1) to px(-2.6),py(0.9) arrowstyle 3 lc rgb "#00694B"
set label 8 "z, height\nof the track" at px(-2.75),py(0.85) right textcolor rgb "#00694B"
set arrow 13 from px(0),py(-1.05) to px(0),py(-0.06) arrowstyle 3 lc rgb "#8A3A70" front
set label 9 "g, dynamic part of the wheel force" at px(0.15),py(-0.78) front textcolor rgb "#8A3A70"
set arrow 14 from px(1.2),py(0.78) to px(2.3),py(0.78) arrowstyle 3 lc rgb black
set label 10 "speed v" at px(1.75),py(1.02) center
set arrow 15 from px(5),py(0.2) to px(10),py(0.2) arrowstyle 2 lc rgb black
set label 11 "wavelength λ" at px(7.5),py(0.42) center
set arrow 16 from px(7.5),py(-0.5) to px(7.5),py(-0.25) nohead lw 3 lc rgb black front
set label 12 "amplitude A" at px(7.5),py(-0.78) center font ",10" front
set label 13 "What may A be, if no speed up to\nthe posted one is to use up more\nthan the stroke limit x_0?" at px(4.6),py(4.4) font ",11"
set label 14 "Short waves: A constant.\nLong waves: A grows as λ^2.\nVery short waves: the wheel\nforce decides." at px(4.6),py(2.75) font ",11"
plot ARG1 using (px(column("x"))):(py(column("z"))):(-20) with filledcurves y=0 fc rgb "#EFEBE2", \
     ARG1 using (px(column("x"))):(py(column("z"))) with lines lt 1 lw 2.4, \
     ARG3 using (px(column("x"))):(py(column("z"))) with lines lt 1 lw 2.0
do for [i=1:4] { unset object i }
do for [i=1:16] { unset arrow i; if (i < 15) { unset label i } }
set border 3
set tics nomirror out scale 0.75
set grid xtics ytics back lc rgb "#CCCCCC" lw 1 dt solid
set lmargin at screen 0.1
set rmargin at screen 0.985
set xrange [0:850]
set xtics 100 nomirror
set tmargin at screen 0.47
set bmargin at screen 0.315
set format x ""
set yrange [-20:70]
set ytics 20 nomirror
set ylabel "track z, mm" offset 0.6,0
set label 1 "a hill of 300 m" at 250,12 center
set label 2 "a bump\nof 10 m" at 500,52 center
set label 3 "waves of 50 m" at 675,32 center
plot ARG4 using "x_m":"z_mm" with lines lt 4 dt 1 lw 2.2
set tmargin at screen 0.28
set bmargin at screen 0.105
set format x "%g"
set yrange [-1.3:1.3]
set ytics 0.5 nomirror
set ylabel "descriptor p" offset 1.2,0
set xlabel "distance, m" offset 0,0.4
unset label 1; unset label 2; unset label 3
set label 1 "the limit for lasting waves" at 10,1.2
set arrow 1 from 0,1 to 850,1 nohead ls guide
set arrow 2 from 0,-1 to 850,-1 nohead ls guide
plot ARG4 using "x_m":"descriptor" with lines lt 3 dt 1 lw 2.0
unset multiplot
