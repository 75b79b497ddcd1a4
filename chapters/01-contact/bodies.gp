# alt: Four drawings. From the side, a wheel of radius R_w on a rail, with y along the rail and z_1, z_2 into wheel and rail from the point O. Across the rail, the hollow tread on the crown of the rail and beside it the sharper corner, with the gap f between them. From above, the closed curve f = δ around the contact Ω, which is cut into columns of cells, with the ends A and B on the x axis. The pressure along x, with its peak just beyond the jump and the force to the left of it.
# Example 2 as a drawing of the page's axes and symbols: profile (ARG1), cells (ARG3), interpenetration curve (ARG4), pressure (ARG5).
load "style.gp"
set terminal pngcairo size 740,640 font "DejaVu Sans,12" enhanced background rgb "white"
set output ARG2
set minussign
stats ARG6 using "x_in" name "load" nooutput
set multiplot
unset grid
unset key
unset border
unset tics
set tmargin 0
set bmargin 0
set lmargin 0
set rmargin 0
axis = 50
set style line axis lc rgb black lw 1.6
set style fill solid 0.25 noborder

# The wheel from its side, to scale.
set lmargin at screen 0.02
set rmargin at screen 0.47
set bmargin at screen 0.55
set tmargin at screen 0.97
set xrange [-16:16]
set yrange [-5.5:20.35]
set label 1 "{/:Bold From the side}" at graph 0.02,0.96
set object 1 circle at 0,18 size 18 arc [216:324] fc rgb sky fs solid 0.25 noborder
set object 2 rectangle from -16,-5.5 to 16,0 fc rgb grey fs solid 0.25 noborder
set arrow 1 from 0,18 to 18*cos(235.0*pi/180),18+18*sin(235.0*pi/180) lw 1.4 lc rgb blue size 0.7,20 filled
set label 2 "{/:Italic R}_w = 18 in" at -6.6,11 textcolor rgb blue right
set arrow 2 from 0,0 to 7.2,0 ls axis size 0.8,20 filled front
set label 3 "{/:Italic y}" at 8,0 front
set arrow 3 from 0,0 to 0,6 ls axis size 0.8,20 filled front
set label 4 "{/:Italic z}_1" at 0.8,5.6 front
set arrow 4 from 0,0 to 0,-5.2 ls axis size 0.8,20 filled front
set label 5 "{/:Italic z}_2" at 0.7,-5 front
set label 6 "O" at -1.6,1.1 front
set label 7 "wheel" at 3,13 textcolor rgb "#3A799C"
set label 8 "rail" at -14,-2.5 textcolor rgb "#606060" front
set object 3 circle at 0,18 size 0.35 fc rgb blue fs solid
plot NaN with points
unset for [i=1:8] label i
unset for [i=1:4] arrow i
unset for [i=1:3] object i

# The profiles, heights three times.
set lmargin at screen 0.50
set rmargin at screen 0.99
set xrange [-1.5:1.05]
set yrange [-0.39:0.27]
set label 1 "{/:Bold Across the rail}, heights enlarged 3 : 1" at graph 0.02,0.96
set arrow 1 from 0,0 to 0.42,0 ls axis size 0.05,20 filled front
set label 2 "{/:Italic x}" at 0.45,0.005 front
set arrow 2 from 0,0 to 0,0.15 ls axis size 0.05,20 filled front
set label 3 "{/:Italic z}_1" at 0.04,0.15 front
set arrow 3 from 0,0 to 0,-0.12 ls axis size 0.05,20 filled front
set label 4 "{/:Italic z}_2" at 0.04,-0.125 front
set label 5 "O" at -0.11,0.03 front
set label 6 "rail's crown, {/:Italic R}_r = 10 in" at -1.42,-0.19 textcolor rgb "#404040" front
set label 7 "corner,\n{/:Italic R}_r = 1.25 in" at 0.05,-0.25 textcolor rgb "#404040" front
set label 8 "tread, {/:Italic R}_t = 12.34 in" at -1.42,0.155 textcolor rgb "#3A799C" front
set arrow 4 from 0.62,-0.62*0.62/2.5 to 0.62,-0.62*0.62/24.68 heads lw 1.4 lc rgb red size 0.04,20 filled front
set label 9 "gap {/:Italic f}" at 0.66,-0.075 textcolor rgb "#BE5400" front
plot ARG1 using "x_in":"wheel_in":(0.2) with filledcurves lc rgb sky, \
     "" using "x_in":"rail_in":(-0.39) with filledcurves lc rgb grey, \
     "" using "x_in":"wheel_in" with lines lw 2 dt solid lc rgb blue, \
     "" using "x_in":"rail_in" with lines lw 2 dt solid lc rgb black
unset for [i=1:9] label i
unset for [i=1:4] arrow i

# The patch from above, to scale.
set style fill empty
set lmargin at screen 0.02
set rmargin at screen 0.47
set bmargin at screen 0.02
set tmargin at screen 0.47
set xrange [-0.82:0.42]
set yrange [-0.52:0.5524]
set label 1 "{/:Bold From above}, approach {/:Italic δ} = 0.005 in" at graph 0.02,0.96
set arrow 1 from -0.78,0 to 0.24,0 ls axis size 0.035,20 filled front
set label 2 "{/:Italic x}" at 0.26,0 front
set arrow 2 from 0,-0.46 to 0,0.4 ls axis size 0.035,20 filled front
set label 3 "{/:Italic y}" at -0.02,0.385 right front
set label 4 "curve\n{/:Italic f} = {/:Italic δ}" at -0.80,0.33 textcolor rgb "#BE5400"
set label 5 "contact {/:Italic Ω}" at -0.70,-0.47 textcolor rgb "#404040"
set label 6 "cell {/:Italic Ω}_j,\npressure {/:Italic p}_j" at 0.135,-0.17 textcolor rgb purple
set arrow 3 from 0.12,-0.16 to -0.053,-0.1 lw 1.2 lc rgb purple size 0.02,20 filled front
set arrow 4 from -0.55,-0.42 to -0.40,-0.12 lw 1.2 lc rgb "#404040" size 0.02,20 filled front
set label 7 "A" at -0.585,0.035 right front
set label 8 "B" at 0.065,0.035 left front
one(x, y) = abs(column("x_in") + 0.0553) < 0.006 && abs(column("y_in") + 0.1042) < 0.01 ? column("x_in") : NaN
plot ARG3 using "x_in":"y_in":(0.5*column("dx_in")):(0.5*column("dy_in")) with boxxyerror fs solid 0.25 border lc rgb grey lw 0.6, \
     "" using (one(1,1)):"y_in":(0.5*column("dx_in")):(0.5*column("dy_in")) with boxxyerror fs solid 1 noborder lc rgb purple, \
     ARG4 using "x_in":"y_in" with lines lt 3 lw 2
unset for [i=1:8] label i
unset for [i=1:4] arrow i

# The pressure along the axis.
set lmargin at screen 0.58
set rmargin at screen 0.97
set bmargin at screen 0.10
set tmargin at screen 0.40
set border 3
set tics nomirror out scale 0.6
set xtics 0.2 nomirror
set ytics 1 nomirror
set xrange [-0.62:0.1]
set yrange [0:3.2]
set xlabel "{/:Italic x}, in" offset 0,0.4
set ylabel "{/:Italic p}({/:Italic x}, 0), 10^5 psi" offset 1,0
set label 1 "{/:Bold Pressure along} {/:Italic x}" at screen 0.51,0.4485
set label 2 "peak" at -0.01,3.02 right
set arrow 1 from load_max,2.5 to load_max,0 lw 2.4 lc rgb blue size 0.025,20 filled front
set label 3 "force {/:Italic F}\nat {/:Italic x} = {/:Italic M}_y/{/:Italic F}" at load_max-0.02,2.45 right textcolor rgb blue
plot ARG5 using "x_in":"p_1e5_psi" with filledcurves y1=0 fs solid 0.25 noborder lc rgb grey, \
     "" using "x_in":"p_1e5_psi" with lines lt 1 lw 2
unset multiplot
