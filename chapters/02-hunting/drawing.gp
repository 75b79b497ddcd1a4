# The drawing at the head of the page. ARG1: the car displaced; ARG3, ARG4: its trucks together and opposed. Each has
# part, x, y in feet, seen from above, forward to the right. The wheelset from behind and its way are sketches.
# alt: A wheelset from behind, displaced to the left, so that its left wheel rolls on a larger radius than the right one;
# alt: its wave along the track from above; the car from above with its nine coordinates; below, the car with both trucks to the
# alt: same side and the body beside them, the car with trucks to opposite sides and the body turned, and the body rolled.
load "style.gp"
set terminal pngcairo size 740,640 font "DejaVu Sans,12" enhanced background rgb "white"
set output ARG2
W = 740.0; H = 640.0
unset border
unset tics
unset grid
unset key
set style line 1 lc rgb "#404040" lw 1.2 dt solid
set style line 2 lc rgb black lw 5 dt solid
set style line 3 lc rgb red lw 3 dt solid
set style line 4 lc rgb blue lw 1.8 dt solid
set style line 5 lc rgb grey lw 1 dt (6,4)
set style arrow 1 head filled size screen 0.013,18 lc rgb black lw 1.5
set style arrow 2 heads filled size screen 0.010,18 lc rgb black lw 1.1
set style arrow 3 nohead lc rgb grey lw 1 dt (4,3)
part(name) = strcol("part") eq name ? $2 : NaN
set multiplot

# A wheelset from behind: coned wheels on an axle, x to the left of the middle of the track.
set lmargin at screen 0; set rmargin at screen 300/W
set bmargin at screen 415/H; set tmargin at screen 610/H
set xrange [-4.9:4.4]
set yrange [-1.0:5.045]
g = 2.48; R = 1.75; taper = 0.30; x = -0.62
turn = atan(-taper*x/g)
px(u, v) = x + u*cos(turn) + v*sin(turn)
pz(u, v) = R - u*sin(turn) + v*cos(turn)
rad(u) = R + taper*(g - u)
i = 1.35; t = 1.75; o = 3.25; f = 0.35
do for [s = -1:1:2] {
  set object polygon from px(s*i, rad(t) + f), pz(s*i, rad(t) + f) to px(s*(t - 0.15), rad(t) + f), pz(s*(t - 0.15), rad(t) + f) \
      to px(s*t, rad(t)), pz(s*t, rad(t)) to px(s*o, rad(o)), pz(s*o, rad(o)) \
      to px(s*o, -rad(o)), pz(s*o, -rad(o)) to px(s*t, -rad(t)), pz(s*t, -rad(t)) \
      to px(s*(t - 0.15), -rad(t) - f), pz(s*(t - 0.15), -rad(t) - f) to px(s*i, -rad(t) - f), pz(s*i, -rad(t) - f) \
      to px(s*i, rad(t) + f), pz(s*i, rad(t) + f) fc rgb "#E4E4E4" fs solid 1.0 border lc rgb "#404040"
  y0 = s*g; top = pz(s*g - x, -rad(g - s*x))
  set object polygon from y0 - 0.32, top to y0 + 0.32, top to y0 + 0.32, top - 0.35 to y0 + 0.1, top - 0.45 to y0 + 0.1, top - 0.95 \
      to y0 - 0.1, top - 0.95 to y0 - 0.1, top - 0.45 to y0 - 0.32, top - 0.35 to y0 - 0.32, top fc rgb sky fs solid 0.6 border lc rgb blue
}
set arrow from px(-o - 0.5, 0), pz(-o - 0.5, 0) to px(o + 0.5, 0), pz(o + 0.5, 0) nohead lc rgb "#404040" lw 2.5 front
set arrow from -g, pz(-g - x, 0) to -g, pz(-g - x, -rad(g + x)) as 2 front
set arrow from g, pz(g - x, 0) to g, pz(g - x, -rad(g - x)) as 2 front
set label "r_L" at -g - 0.15, pz(-g - x, 0) - 1.0 right front
set label "r_R" at g + 0.15, pz(g - x, 0) - 0.85 left front
set arrow from 0, -0.75 to 0, 4.5 as 3
set arrow from x, 1.0 to x, 4.3 as 3
set arrow from 0, 4.1 to x, 4.1 as 1
set label "x_w" at x - 0.15, 4.15 right
set arrow from -g, -0.72 to g, -0.72 as 2
set label "2a" at -1.0, -0.42
set arrow from 0.75, R to 1.3, R as 3
set label "φ_w" at -0.05, pz(0.5, 0) - 0.33 left font ",11"
top = pz(-g - x, -rad(g + x)); w = atan(taper) + turn
set arrow from -g, top to -g - 1.7, top as 3 front
set arrow from -g, top to -g - 1.7, top + 1.7*tan(w) nohead lc rgb red lw 1.4 front
set label "δ_L" at -g - 1.75, top + 0.25 right front
set label "left rail" at -g - 0.45, -0.55 right tc rgb blue font ",11"
set label "right rail" at g + 0.4, -0.55 left tc rgb blue font ",11"
set label "flange" at -1.75, 0.3 left font ",11"
set label "from behind: larger radius at the left" at screen 8/W, screen 627/H left font ",12"
plot NaN

# The way of a wheelset along the track, from above.
unset label; unset arrow; unset object
set lmargin at screen 335/W; set rmargin at screen 735/W
set xrange [0:40]; set yrange [-9.75:9.75]
g = 4.2; A = 1.5; L = 32.0
way(s) = A*sin(2*pi*s/L)
yaw(s) = atan(A*2*pi/L*cos(2*pi*s/L))
set arrow from 0, g to 40, g nohead lc rgb sky lw 5 dt solid
set arrow from 0, -g to 40, -g nohead lc rgb sky lw 5 dt solid
do for [k = 0:4] {
  s = 4 + 8*k; c = cos(yaw(s)); n = sin(yaw(s))
  set arrow from s + (g + 0.9)*n, way(s) - (g + 0.9)*c to s - (g + 0.9)*n, way(s) + (g + 0.9)*c nohead ls 1 front
  do for [m = -1:1:2] {
    ax = s - m*g*n; ay = way(s) + m*g*c
    set arrow from ax - 1.5*c, ay - 1.5*n to ax + 1.5*c, ay + 1.5*n nohead ls 2 front
  }
}
set arrow from 33, 8.3 to 39, 8.3 as 1
set label "speed V" at 32.4, 8.3 right
set arrow from 4, -7.4 to 36, -7.4 as 2
set label "one wave" at 20, -8.8 center font ",11"
set label "from above: the side of the larger wheel runs ahead" at screen 735/W, screen 627/H right font ",12"
plot way(x) with lines ls 5

# The nine coordinates.
unset label; unset arrow; unset object
set lmargin at screen 5/W; set rmargin at screen 735/W
set bmargin at screen 195/H; set tmargin at screen 402/H
set xrange [-24.8:24.8]; set yrange [-7.25:6.815]
set arrow from -24.5, 0 to 24.5, 0 as 3
set label "from above: the nine coordinates, enlarged" at screen 8/W, screen 400/H left font ",12"
set label "car body" at -4.5, -2.5 tc rgb blue
plot ARG1 using (part("body")):3 with lines ls 4, \
     ARG1 using (part("frame")):3 with lines ls 3, \
     ARG1 using (part("axle")):3 with lines ls 1, \
     ARG1 using (part("wheel")):3 with lines ls 2, \
     ARG5 using (strcol(1) eq "arrow" ? $2 : NaN):3:4:5 with vectors as 1, \
     ARG5 using (strcol(1) eq "thin" ? $2 : NaN):3:4:5 with vectors as 3, \
     ARG5 using (strcol(1) eq "measure" ? $2 : NaN):3:4:5 with vectors as 2, \
     ARG6 using 1:2 with lines lc rgb black lw 1.2, \
     ARG5 using (strcol(1) eq "label" ? $2 : NaN):3:6 with labels left font ",12"

# Two families.
unset label; unset arrow
set bmargin at screen 5/H; set tmargin at screen 160/H
set xrange [-22.5:22.5]; set yrange [-11.8:11.45]
set arrow from -22, 0 to 22, 0 as 3
set arrow from 16.9, 0 to 16.9, 1.6 as 1 front
set arrow from -16.9, 0 to -16.9, 1.6 as 1 front
set lmargin at screen 5/W; set rmargin at screen 305/W
set label "trucks together: the body sways" at graph 0.5, 0.93 center font ",12"
plot ARG3 using (part("body")):3 with lines ls 4, \
     ARG3 using (part("frame")):3 with lines ls 3, \
     ARG3 using (part("axle")):3 with lines ls 1, \
     ARG3 using (part("wheel")):3 with lines ls 2
unset label; unset arrow
set arrow from -22, 0 to 22, 0 as 3
set arrow from 16.9, 0 to 16.9, 1.6 as 1 front
set arrow from -16.9, 0 to -16.9, -1.6 as 1 front
set lmargin at screen 312/W; set rmargin at screen 612/W
set label "trucks opposed: the body yaws" at graph 0.5, 0.93 center font ",12"
plot ARG4 using (part("body")):3 with lines ls 4, \
     ARG4 using (part("frame")):3 with lines ls 3, \
     ARG4 using (part("axle")):3 with lines ls 1, \
     ARG4 using (part("wheel")):3 with lines ls 2

# The body from behind.
unset label; unset arrow
set lmargin at screen 622/W; set rmargin at screen 738/W
set xrange [-8:8]; set yrange [-1.5:20.4]
set label "body roll" at graph 0.5, 0.93 center font ",12"
p = 0.2; hh = 9.2
bx(u, v) = 0.5 + u*cos(p) + v*sin(p)
bz(u, v) = hh - u*sin(p) + v*cos(p)
set object polygon from bx(-4.6, 5), bz(-4.6, 5) to bx(4.6, 5), bz(4.6, 5) to bx(4.6, -4.2), bz(4.6, -4.2) to bx(-4.6, -4.2), bz(-4.6, -4.2) \
    to bx(-4.6, 5), bz(-4.6, 5) fs empty border lc rgb blue lw 1.8
set arrow from -3.6, 1.4 to 3.6, 1.4 nohead ls 1
do for [m = -1:1:2] {
  set arrow from m*2.48, 0 to m*2.48, 2.75 nohead lw 5 lc rgb black dt solid
  set arrow from m*2.48 - 0.5, -0.4 to m*2.48 + 0.5, -0.4 nohead lw 4 lc rgb sky dt solid
}
set arrow from bx(0, 0), bz(0, 0) to bx(0, -3), bz(0, -3) as 2 front
set arrow from 0.5, hh to 0.5, hh + 4.5 as 3
set arrow from bx(0, 0), bz(0, 0) to bx(0, 4.5), bz(0, 4.5) as 3
set label "φ_C" at 1.6, hh + 3.4
set label "h_2" at 0.9, hh - 1.6
plot NaN
unset multiplot
