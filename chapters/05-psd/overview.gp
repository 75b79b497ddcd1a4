# alt: Three panels. Top left: a row of rails that sag at their joints to a depth b, with a chord of 62 ft stretched across one joint and the offset in its middle. Bottom left: a wavy record of the rail's height over eight rail lengths, in millimetres. Right: the spectrum of such a record on logarithmic axes, falling with slope -2 up to the corner phi_c and with slope -4 beyond it, with a peak at one over the rail length.
load "style.gp"
set terminal pngcairo size 1100,600 font "DejaVu Sans,13" enhanced background rgb "white"
set output ARG2
stats ARG5 using "phi_0" name "P" nooutput
stats ARG5 using "phi_c" name "C" nooutput
stats ARG5 using "S_under" name "U" nooutput
stats ARG5 using "S_peak" name "H" nooutput
stats ARG5 using "S_corner" name "K" nooutput
l = 11.8872
chord = 18.8976
set minussign
set multiplot
unset key
unset grid

# The rails, the chord, the dip.
set lmargin at screen 0.055
set rmargin at screen 0.475
set tmargin at screen 0.93
set bmargin at screen 0.60
set title "{/:Bold The rail}, its dips {/:Italic b} drawn far too deep" offset 0,-0.4
unset border
unset xtics
unset ytics
set xrange [0:4*l]
set yrange [-0.62:1.6]
end = abs(sin(pi * (2 * l - chord / 2) / l))
set for [i=0:27] object i+1 rectangle from i*1.7+0.45,-0.42 to i*1.7+1.25,-0.24 fc rgb light fs solid noborder
set arrow 1 from 2*l-chord/2,end to 2*l+chord/2,end nohead lw 2 lc rgb red
set arrow 2 from 2*l,0 to 2*l,end heads filled size 0.6,20 lw 1.6 lc rgb red
set label 1 "mid-chord offset" at 2*l,-0.12 center tc rgb red
set label 2 "chord {/:Italic L} = 62 ft (19 m)" at 9.5,1.36 center tc rgb red
set arrow 6 from 13,1.2 to 16.5,end+0.03 lw 1.2 lc rgb red size 0.6,20 filled
set arrow 3 from l,0 to l,1 heads filled size 0.6,20 lw 1.6 lc rgb black
set label 3 "{/:Italic b}" at l+0.8,0.72
set arrow 4 from 0.5*l,1 to 1.5*l,1 nohead ls guide
set arrow 5 from 2*l,1.17 to 3*l,1.17 heads filled size 0.6,20 lw 1.6 lc rgb blue
set label 4 "rail length {/:Italic l} = 1/φ_0" at 2.5*l,1.36 center tc rgb blue
set label 5 "joint" at 3*l,-0.12 center
set label 6 "ties" at 0.2,-0.55
plot ARG1 using "x_m":"z_over_B" with lines lt 1
unset for [i=0:27] object i+1
unset label
unset arrow

# The record.
set tmargin at screen 0.47
set bmargin at screen 0.115
set lmargin at screen 0.085
set title "{/:Bold Its record}" offset 0,-0.4
set border 3 lw 1.2 lc rgb "#404040"
set xtics nomirror out 20 scale 0.75
set ytics nomirror out scale 0.75 autofreq
set xrange [0:8*l]
set offsets 0,0,9,0
set yrange [*:*]
set xlabel "distance {/:Italic x} along the rail, m" offset 0,0.3
set ylabel "height {/:Italic z}, mm" offset 0
set for [i=1:7] arrow i from i*l,graph 1.0 to i*l,graph 0.91 lc rgb blue lw 1.4 size 1,20 filled
set label 1 "joints" at 0.14*l,graph 0.95 tc rgb blue
plot ARG3 using "x_m":"z_mm" with lines lt 1 lw 1.8
unset label
unset arrow

# The spectrum.
set offsets 0,0,0,0
set lmargin at screen 0.615
set rmargin at screen 0.985
set tmargin at screen 0.93
set bmargin at screen 0.115
set title "{/:Bold Its spectrum}, as three numbers"
set logscale xy
set xrange [0.01:0.6]
set yrange [1e-8:1e-2]
set format y "10^{%T}"
set ytics 1e-8,10,1e-2
set xtics ("0.01" 0.01, "0.02" 0.02, "0.05" 0.05, "0.1" 0.1, "0.2" 0.2, "0.5" 0.5)
set xlabel "wavenumber φ, cycle/m"
set ylabel "density {/:Italic S_z}, m²/(cycle/m)" offset 0
set label 1 "slope −2:\nroughness {/:Italic A}\n{/:Italic S_z} = {/:Italic A}/φ²" at 0.0125,6e-5 tc rgb blue
set arrow 1 from 0.019,9e-5 to 0.025,7.6e-4 lw 1.2 lc rgb blue size 0.01,20 filled
set label 2 "slope −4:\n{/:Italic S_z} = {/:Italic A}φ_c²/φ⁴" at 0.215,1.1e-4 tc rgb blue
set arrow 3 from C_max,1e-8 to C_max,K_max ls guide nohead
set arrow 7 from 0.27,3.5e-5 to 0.222,6.4e-6 lw 1.2 lc rgb blue size 0.01,20 filled
set label 3 "corner φ_c" at C_max*1.03,1.7e-8 tc rgb blue
set arrow 4 from P_max,1e-8 to P_max,U_max ls guide nohead
set label 4 "φ_0 = 1/{/:Italic l}" at P_max*0.97,1.7e-8 right
set label 5 "peak of height {/:Italic C}_1\nand width β:\ndip {/:Italic b} of the joints" at P_max*1.25,1.4e-3 tc rgb red
set arrow 5 from P_max*1.22,5.5e-4 to P_max*1.04,H_max*0.97 lw 1.2 lc rgb red size 0.01,20 filled
set label 6 "2φ_0" at 2.02*P_max,3.6e-5 center
set label 7 "3φ_0" at 3.05*P_max,7e-6 left
plot ARG4 using "phi_cycle_per_m":"S" with lines lt 1, \
     ARG4 using "phi_cycle_per_m":"S_random" with lines lt 2 lw 1.8
unset multiplot
