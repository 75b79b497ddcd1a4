# alt: Left: a small wheel, pressed by the load N on top of a big one four and a half times as large. The big wheel drives, the small one is braked; arrows show both speeds, both radii and the friction force T at the contact. Right: the contact from above, an ellipse with semi-axes a along rolling and b across. Its cells stick in the front part and slide behind, with arrows of traction; below, the traction along the middle grows from the leading edge until it meets its limit.
# The rig, radii in ARG4; the contact, cells in ARG1 and the middle row in ARG3.
load "style.gp"
set output ARG2
set terminal pngcairo size 1100,460 font "DejaVu Sans,13" enhanced background rgb "white"
stats ARG4 using "small_cm" name "s" nooutput
stats ARG4 using "big_cm" name "l" nooutput
r = s_max
R = l_max
set multiplot
unset grid
unset key
unset border
unset tics
set bmargin at screen 0.01
set tmargin at screen 0.99

# The wheels to scale, in cm from the axle of the big one.
set lmargin at screen 0
set rmargin at screen 0.5
set xrange [-56:56]
set yrange [-20:71.8]  # as many pixels a centimetre as along x: the wheels touch
set object 1 circle at 0,0 size R fc rgb light fs solid 0.7 border lc rgb "#404040"
set object 2 circle at 0,R+r size r fc rgb sky fs solid 0.4 border lc rgb "#404040"
set object 3 circle at 0,0 size 0.7 fc rgb "#404040" fs solid
set object 4 circle at 0,R+r size 0.7 fc rgb "#404040" fs solid
set object 5 circle at 0,R+r size 4.2 fc rgb "#606060" fs empty border lc rgb "#606060" dt (4,3)
set object 6 circle at 0,0 size 9 fc rgb "#606060" fs empty border lc rgb "#606060" dt (4,3)
set object 7 circle at 0,R size 1.6 fc rgb red fs empty border lc rgb red lw 2 front
set arrow 1 from 0,70.8 to 0,R+r+1 lw 3 lc rgb black size 1.8,20 filled front
set label 1 "load {/:Italic N}" at 1.5,69 left
set arrow 2 from -1.5,R+1.1 to -17,R+1.1 lw 3 lc rgb red size 1.8,20 filled front
set label 2 "friction force {/:Italic T}\non the small wheel" at -18,R+7.5 right textcolor rgb "#BE5400"
set arrow 3 from 0,R+r to 0.71*r,R+r+0.71*r lw 1.4 lc rgb blue size 1.2,20 filled front
set label 3 "{/:Italic R}_S" at 0.71*r+1,R+r+0.71*r+1.2 left textcolor rgb blue
set arrow 4 from 0,0 to 0.8*R,-0.6*R lw 1.4 lc rgb blue size 1.2,20 filled front
set label 4 "{/:Italic R}_B" at 17,-17 left textcolor rgb blue
# Turning: arcs with a head at one end.
set object 8 circle at 0,R+r size r+2.5 arc [130:195] nowedge fs empty border lc rgb "#404040" lw 2 front
set arrow 5 from (r+2.5)*cos(132*pi/180),R+r+(r+2.5)*sin(132*pi/180) to (r+2.5)*cos(126*pi/180),R+r+(r+2.5)*sin(126*pi/180) lw 2 lc rgb "#404040" size 1.8,20 filled front
set label 5 "small wheel, braked,\nat speed {/:Italic N}_S" at -(r+5),R+r+9 right
do for [k=1:10] { set arrow 20+k from (R+2.5)*cos((121.5+3.5*k)*pi/180),(R+2.5)*sin((121.5+3.5*k)*pi/180) to (R+2.5)*cos((125+3.5*k)*pi/180),(R+2.5)*sin((125+3.5*k)*pi/180) nohead lw 2 lc rgb "#404040" }
set arrow 6 from (R+2.5)*cos(159.5*pi/180),(R+2.5)*sin(159.5*pi/180) to (R+2.5)*cos(161*pi/180),(R+2.5)*sin(161*pi/180) lw 2 lc rgb "#404040" size 1.8,20 filled front
set label 6 "big wheel, drives,\nat speed {/:Italic N}_B" at -33,17 left
set label 7 "dashed: gears of\n144 teeth, which\ncount the turns" at 12,6 left textcolor rgb "#404040"
set label 8 "contact" at 16,R+1.6 left textcolor rgb "#BE5400" front
set arrow 7 from 15,R+1.6 to 2,R+0.2 nohead lw 1 lc rgb red front
plot NaN with points
do for [i=1:9] { unset label i; unset object i }
do for [i=1:7] { unset arrow i }
do for [i=21:30] { unset arrow i }

# The contact from above: tractions on the small wheel.
set lmargin at screen 0.565
set rmargin at screen 0.985
set tmargin at screen 0.93
set bmargin at screen 0.46
set xrange [-1.75:1.75]
set yrange [-1.12:1.12]
set label 1 "The contact from above; arrows are tractions" at screen 0.535,0.965 left
set label 2 "slides" at -1.72,0.75 left textcolor rgb "#BE5400"
set label 3 "sticks" at 1.72,0.75 right textcolor rgb "#005A8E"
set arrow 1 from 0,0 to 1.4908,0 lw 1.6 lc rgb black size 0.07,20 filled front
set label 4 "{/:Italic a}" at 1.54,0.02 front
set arrow 2 from 0,0 to 0,0.9507 lw 1.6 lc rgb black size 0.07,20 filled front
set label 5 "{/:Italic b}" at 0.07,0.98 front
set label 6 "material\nenters" at 1.72,-0.8 right textcolor rgb "#404040"
set arrow 3 from 1.72,-0.5 to 1.2,-0.5 lw 2 lc rgb "#404040" size 0.09,20 filled front
scale = 0.00052
plot ARG1 using "x_mm":"y_mm":(0.5*column("dx_mm")):(0.5*column("dy_mm")):(column("sticks") > 0.5 ? 0xBFDDEE : 0xF6D3BF) with boxxyerror fs solid 1 border lc rgb "white" lw 0.4 fc rgb variable, \
     ARG1 every 3 using (column("x_mm")-0.5*scale*column("tx_MPa")):"y_mm":(scale*column("tx_MPa")):(scale*column("ty_MPa")) with vectors dt solid lw 1.1 lc rgb "#404040" size 0.04,20 filled
do for [i=2:6] { unset label i }
do for [i=1:3] { unset arrow i }

# The middle row.
set tmargin at screen 0.43
set bmargin at screen 0.14
set border 3
set tics nomirror out scale 0.6
set xtics nomirror 0.5
set ytics nomirror 200
set yrange [0:500]
set xlabel "along rolling, mm" offset 0,0.4
set ylabel "traction, MPa" offset 0.5,0
set label 2 "limit: pressure × {/:Italic µ}_c" at 0.55,472 left textcolor rgb "#606060"
set label 3 "traction" at 0.35,110 right textcolor rgb black
plot ARG3 using "x_mm":"limit_MPa" with lines ls guide lc rgb "#606060" lw 2, \
     ARG3 using "x_mm":"traction_MPa" with lines lt 1
unset multiplot
