# alt: Two wheels under their loads, each on a contact spring, a rail mass, a spring and a damper, a
# alt: mass of tie and ballast, and a spring and a damper to the ground; an arrow between the rail
# alt: masses says that each load moves the other.
load "style.gp"
set terminal pngcairo size 840,640
set output ARG2
unset border
unset tics
unset grid
unset key
set xrange [-2.3:5.9]
set yrange [0.2:6.45]
set size ratio -1
set margins 0,0,0,0
set style arrow 1 nohead lw 2 lc rgb black
set style rectangle fillstyle empty border lc rgb black linewidth 2
array X = [0, -0.35, -0.35]
array LOW = [3.6, 2.2, 0.7]
array HIGH = [4.4, 3.2, 1.7]
zig(i) = i == 0 || i == 6 ? 0 : i % 2 ? 0.14 : -0.14
# Both wheels of a truck on one rail: each with its contact, the rail, the ties
do for [w = 0:1] {
  m = 4.5 * w
  set object circle at m,4.95 size 0.55 fillstyle empty border lc rgb black lw 2
  set object rectangle from m-0.6,3.2 to m+0.6,3.6
  set object rectangle from m-0.8,1.7 to m+0.8,2.2
  do for [k = 1:3] {
    lead = 0.18 * (HIGH[k] - LOW[k])
    turn = (HIGH[k] - LOW[k] - 2 * lead) / 6
    set arrow from m+X[k],LOW[k] to m+X[k],LOW[k] + lead as 1
    set arrow from m+X[k],HIGH[k] - lead to m+X[k],HIGH[k] as 1
    do for [i = 0:5] {
      set arrow from m + X[k] + zig(i),LOW[k] + lead + turn * i \
        to m + X[k] + zig(i + 1),LOW[k] + lead + turn * (i + 1) as 1
    }
  }
  do for [k = 2:3] {
    middle = 0.5 * (LOW[k] + HIGH[k])
    set arrow from m+0.35,LOW[k] to m+0.35,middle - 0.12 as 1
    set arrow from m+0.35,middle + 0.05 to m+0.35,HIGH[k] as 1
    set arrow from m+0.25,middle + 0.05 to m+0.45,middle + 0.05 as 1
    set arrow from m+0.21,middle - 0.12 to m+0.49,middle - 0.12 as 1
    do for [side = -1:1:2] {
      set arrow from m + 0.35 + 0.14 * side,middle - 0.12 to m + 0.35 + 0.14 * side,middle + 0.18 as 1
    }
  }
  set arrow from m-1.1,0.7 to m+1.1,0.7 as 1
  do for [i = -5:4] { set arrow from m + 0.22 * i,0.5 to m + 0.22 * i + 0.2,0.7 as 1 }
  set arrow from m,5.95 to m,5.5 lc rgb red lw 3 front
  set label "P_0" at m+0.2,5.8 left
  set label "m_w" at m,4.95 center
  set label "M_{rail}" at m,3.4 center
  set label "K_1" at m-0.85,2.7 center
  set label "C_1" at m+0.85,2.7 center
  set label "m_t" at m,1.95 center
  set label "K_g" at m-0.85,1.2 center
  set label "C_g" at m+0.85,1.2 center
}
set label "static load on each wheel" at 2.25,6.2 center
set arrow from 3.6,5.5 to 0.9,5.5 lw 2 lc rgb blue
set label "track, relative to the wheels, at V" at 2.25,5.7 center tc rgb blue
set label "rail surface z, dip at a joint" at 2.25,4.75 center
set arrow from 0.6,3.4 to 3.9,3.4 heads lw 2 lc rgb red
set label "each load also moves the rail" at 2.25,3.65 center tc rgb red
set label "under the other wheel, by a(b)" at 2.25,3.12 center tc rgb red
set label "rail on its ties" at 2.25,2.7 center
set label "ballast and subgrade" at 2.25,1.2 center
set label "Hertz contact" at -1.35,4.1 center
set label "F = C_H x@_+^{3/2}" at -1.35,3.85 center
plot ARG1 using "x":"y" with lines lt 1 lw 2
