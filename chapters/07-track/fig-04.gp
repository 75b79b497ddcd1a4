load "style.gp"
set terminal pngcairo size 1000,600
set output ARG2
unset border
unset tics
unset grid
unset key
set xrange [-1.8:4.8]
set yrange [0.3:6.2]
set size ratio -1
set margins 0,0,0,0
set style arrow 1 nohead lw 2 lc rgb black
set style rectangle fillstyle empty border lc rgb black linewidth 2
# The wheel, its contact, the rail, the ties
set object circle at 0,4.95 size 0.55 fillstyle empty border lc rgb black lw 2
set object rectangle from -0.6,3.2 to 0.6,3.6
set object rectangle from -0.8,1.7 to 0.8,2.2
array X = [0, -0.35, -0.35]
array LOW = [3.6, 2.2, 0.7]
array HIGH = [4.4, 3.2, 1.7]
zig(i) = i == 0 || i == 6 ? 0 : i % 2 ? 0.14 : -0.14
do for [k = 1:3] {
  lead = 0.18 * (HIGH[k] - LOW[k])
  turn = (HIGH[k] - LOW[k] - 2 * lead) / 6
  set arrow from X[k],LOW[k] to X[k],LOW[k] + lead as 1
  set arrow from X[k],HIGH[k] - lead to X[k],HIGH[k] as 1
  do for [i = 0:5] {
    set arrow from X[k] + zig(i),LOW[k] + lead + turn * i \
      to X[k] + zig(i + 1),LOW[k] + lead + turn * (i + 1) as 1
  }
}
do for [k = 2:3] {
  middle = 0.5 * (LOW[k] + HIGH[k])
  set arrow from 0.35,LOW[k] to 0.35,middle - 0.12 as 1
  set arrow from 0.35,middle + 0.05 to 0.35,HIGH[k] as 1
  set arrow from 0.25,middle + 0.05 to 0.45,middle + 0.05 as 1
  set arrow from 0.21,middle - 0.12 to 0.49,middle - 0.12 as 1
  do for [side = -1:1:2] {
    set arrow from 0.35 + 0.14 * side,middle - 0.12 to 0.35 + 0.14 * side,middle + 0.18 as 1
  }
}
set arrow from -1.1,0.7 to 1.1,0.7 as 1
do for [i = -5:4] { set arrow from 0.22 * i,0.5 to 0.22 * i + 0.2,0.7 as 1 }
set arrow from 0,5.75 to 0,5.5 lc rgb red lw 3 front
set arrow from 4.3,3.1 to 1.6,3.1 lw 2 lc rgb blue
set label "track, relative to the wheel, at V" at 2.95,3.25 center tc rgb blue
set label "static load P_0" at 0,5.85 center
set label "m_w" at 0,4.95 center
set label "Hertz contact" at -0.95,4.0 center
set label "F = C_H x^{3/2}" at -0.95,3.75 center
set label "M_{rail}" at 0,3.4 center
set label "K_1" at -0.8,2.7 center
set label "C_1" at 0.8,2.7 center
set label "m_t" at 0,1.95 center
set label "K_g" at -0.8,1.2 center
set label "C_g" at 0.8,1.2 center
set label "rail surface z(Vt), dip at a joint" at 2.95,4.25 center
set label "pads and ties" at 2.95,2.7 center
set label "ballast and subgrade" at 2.95,1.2 center
plot ARG1 using "x":"y" with lines lt 1 lw 2
