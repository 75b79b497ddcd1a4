# alt: Three panels. Left: a wheel rolls along a rail towards a joint; the rail lies on ties, ballast and the ground. Middle: the same as a chain of masses and springs, wheel, contact, rail on its ties, tie with ballast, ground. Right: the force between wheel and rail in the milliseconds after the joint, with the sharp peak P1, ripples, and the slow maximum of its running mean, P2.
load "style.gp"
set terminal pngcairo size 1100,560 font "DejaVu Sans,13" enhanced background rgb "white"
set output ARG2
stats ARG3 using "time_ms" name "T" nooutput
stats ARG3 using "first_kN" name "F" nooutput
stats ARG3 using "mean_time_ms" name "S" nooutput
stats ARG3 using "mean_kN" name "M" nooutput
stats ARG3 using "static_kN" name "P" nooutput
set minussign
set multiplot
unset key
unset grid
unset border
unset tics

# The track, to scale in inches but for the dip of the joint.
set lmargin at screen 0.005
set rmargin at screen 0.395
set tmargin at screen 0.93
set bmargin at screen 0.03
set title "{/:Bold Wheel, rail, tie, bed}" offset 0,-0.4
set xrange [-40:40]
set yrange [-42:52]
surface(x) = -1.8 * exp(-abs(x) / 14)
set object 1 polygon from -40,-42 to 40,-42 to 40,-27 to -40,-27 to -40,-42 fc rgb "#D8C3A5" fs solid noborder
set object 2 polygon from -40,-27 to 40,-27 to 40,-13 to -40,-13 to -40,-27 fc rgb "#E4E4E4" fs solid noborder
do for [i=0:3] {
  x = -29.25 + 19.5 * i
  set object 10+i polygon from x-4.5,-15 to x+4.5,-15 to x+8.9,-27 to x-8.9,-27 to x-4.5,-15 fc rgb "#BDBDBD" fs solid noborder
  set object 20+i rectangle from x-4.5,-15.6 to x+4.5,-7.3 fc rgb "#B5835A" fs solid noborder
}
set object 40 circle at -15,18-0.6 size 18 fc rgb sky fs solid 0.35 border lc rgb blue
set arrow 1 from -15,51 to -15,19 filled lw 3 lc rgb red size 2,20
set label 1 "static load {/:Italic P}_0" at -12.5,47 tc rgb red
set arrow 2 from 6,17 to 24,17 filled lw 2.2 lc rgb blue size 2,20
set label 2 "speed {/:Italic V}" at 6,21 tc rgb blue
set label 3 "wheel" at -15,12 center
set label 4 "contact force {/:Italic F}" at 0.5,5.5 tc rgb red
set arrow 4 from 0,5 to -13.2,0.2 lw 1.2 lc rgb red size 1.5,20 filled
set arrow 5 from 29,5.4 to 1,-1.4 lw 1.2 lc rgb black size 1.5,20 filled
set label 5 "joint" at 29.6,6.2
set label 6 "rail" at 26,-4.2 center tc rgb "#FFFFFF" front
set label 7 "tie" at 9.75,-12.1 center tc rgb "#FFFFFF" front
set label 9 "ballast" at 0,-20.5 center
set label 10 "ground (subgrade)" at 0,-34 center
plot "+" using 1:(surface($1)):(surface($1)-7.1) with filledcurves lc rgb "#707070", \
     "+" using 1:(surface($1)) with lines lt 1 lw 2
unset for [i=1:40] object i
unset label
unset arrow

# The model.
set lmargin at screen 0.395
set rmargin at screen 0.605
set title "{/:Bold The model}" offset 0,-0.4
set xrange [-20:23]
set style arrow 1 nohead lw 1.8 lc rgb black
set style rectangle fillstyle solid 0.2 border lc rgb black linewidth 1.5
array X = [0, -5, -5]
array LOW = [3, -14, -34]
array HIGH = [12, -2, -20]
zig(i) = i == 0 || i == 6 ? 0 : i % 2 ? 1.8 : -1.8
do for [k = 1:3] {
  lead = 0.18 * (HIGH[k] - LOW[k])
  turn = (HIGH[k] - LOW[k] - 2 * lead) / 6
  set arrow from X[k],LOW[k] to X[k],LOW[k] + lead as 1
  set arrow from X[k],HIGH[k] - lead to X[k],HIGH[k] as 1
  do for [i = 0:5] {
    set arrow from X[k] + zig(i),LOW[k] + lead + turn * i to X[k] + zig(i + 1),LOW[k] + lead + turn * (i + 1) as 1
  }
}
do for [k = 2:3] {
  middle = 0.5 * (LOW[k] + HIGH[k])
  set arrow from 5,LOW[k] to 5,middle - 1.6 as 1
  set arrow from 5,middle + 0.6 to 5,HIGH[k] as 1
  set arrow from 3.6,middle + 0.6 to 6.4,middle + 0.6 as 1
  set arrow from 3,middle - 1.6 to 7,middle - 1.6 as 1
  do for [side = -1:1:2] { set arrow from 5 + 2 * side,middle - 1.6 to 5 + 2 * side,middle + 2.4 as 1 }
}
set object 1 rectangle from -9,12 to 9,22
set object 2 rectangle from -9,-2 to 9,3
set object 3 rectangle from -9,-20 to 9,-14
set arrow from -12,-34 to 12,-34 as 1
do for [i = -5:5] { set arrow from 2.2 * i - 0.8,-36 to 2.2 * i + 1.2,-34 as 1 }
set arrow from 0,34 to 0,22.5 filled lw 3 lc rgb red size 1.6,20
set label 1 "{/:Italic P}_0" at 1.5,31 tc rgb red
set label 2 "{/:Italic m_w}" at 0,17 center
set label 3 "{/:Italic C_H}" at -3,7.5 right
set label 4 "{/:Italic M}_{rail}" at 0,0.4 center
set label 5 "{/:Italic K}_1" at -8,-8 right
set label 6 "{/:Italic C}_1" at 8,-8
set label 7 "{/:Italic m_t}" at 0,-17 center
set label 8 "{/:Italic K_g}" at -8,-27 right
set label 9 "{/:Italic C_g}" at 8,-27
set label 10 "wheel" at 10,17 tc rgb blue
set label 11 "contact" at 3,7.5 tc rgb blue
set label 12 "rail" at 10,0.4 tc rgb blue
set label 13 "rail on\nits ties" at 12.5,-7.2 tc rgb blue
set label 14 "tie and\nballast" at 10,-16 tc rgb blue
set label 15 "bed" at 13.5,-27 tc rgb blue
plot NaN notitle
unset for [i=1:3] object i
unset label
unset arrow

# What it answers.
set lmargin at screen 0.675
set rmargin at screen 0.985
set bmargin at screen 0.125
set title "{/:Bold The force at the joint}" offset 0,-0.4
set border 3 lw 1.2 lc rgb "#404040"
set xtics nomirror out 5 scale 0.75
set ytics nomirror out 50 scale 0.75
set xrange [-2:16]
set yrange [60:220]
set xlabel "time after the joint, ms"
set ylabel "contact force {/:Italic F}, kN" offset 0.5
set arrow from -2,P_max to 16,P_max nohead ls guide
set label 1 "{/:Italic P}_0" at -1.7,P_max-7
set label 2 "P1" at T_max-0.35,F_max+5 right tc rgb red font ",15"
set label 3 "P2: the highest\nmean over 6 ms" at 8.3,200 tc rgb red
set arrow from 9.9,183 to S_max+0.2,M_max+4 lw 1.2 lc rgb red size 0.4,20 filled
plot ARG1 using "time_ms":"force_kN" with lines lt 1 lw 1.8, \
     ARG1 using "time_ms":"mean_kN" with lines lt 3 dt solid lw 2.2, \
     ARG3 using "time_ms":"first_kN" with points pt 7 ps 1.4 lc rgb red, \
     ARG3 using "mean_time_ms":"mean_kN" with points pt 7 ps 1.4 lc rgb red
unset multiplot
