# alt: Three drawings above each other with the same scale across. Top: the rail head in section and the wheel on it, flange to the left; one arrow of load at the gauge corner, a smaller one nearer to the crown. Middle: the gap between them, which is negative in two places below these arrows. Bottom: the two patches, a slender one at the corner with high pressure and a rounder one with low pressure.
# Profiles in ARG1 (wheel) and ARG3 (rail), gap in ARG4, patches in ARG5, their cells in ARG6.
load "style.gp"
set output ARG2
set terminal pngcairo size 740,720 font "DejaVu Sans,12" enhanced background rgb "white"
set minussign
set multiplot
unset key
unset grid
set lmargin at screen 0.11
set rmargin at screen 0.87
set xrange [-46:2]
stats ARG5 using "load_N" name "load" nooutput
array Y[2]; array Z[2]; array T[2]; array L[2]
n = 0
keep(y, z, t, l) = (n = n + 1, Y[n] = y, Z[n] = z, T[n] = t, L[n] = l, 1)
set yrange [0:2]
set table $unused
plot ARG5 using (keep(column("across_mm"), column("up_mm"), column("angle_rad"), column("load_N")))
unset table

# To scale: 562 pixels for 48 mm.
set tmargin at screen 0.995
set bmargin at screen 0.635
unset border
unset tics
set yrange [-14:8.1]
set label 1 "wheel" at -16,5.5 center front
set label 2 "flange" at -45.5,3 left front
set label 3 "rail" at -16,-7 center front
set label 4 "crown" at -3,-2 center tc rgb "#606060" front
set label 5 "gauge corner" at -33,-9 left tc rgb "#606060" front
set label 7 "{/:Italic y}" at -2.6,-6 center front
set arrow 1 from -6,-6 to -3.4,-6 lw 1.8 lc rgb black size 0.7,20 filled front
set arrow 2 from -6,-6 to -6,-9 lw 1.8 lc rgb black size 0.7,20 filled front
set label 6 "{/:Italic z}" at -6,-9.9 center front
do for [k=1:2] {
  len = 3+5*L[k]/load_max
  set arrow 2+k from Y[k]+len*sin(T[k]),Z[k]+len*cos(T[k]) to Y[k],Z[k] lw 2.6 lc rgb red size 0.9,20 filled front
  set label 7+k sprintf("%.1f kN", L[k]/1000) at Y[k]+len*sin(T[k])+0.6,Z[k]+len*cos(T[k])+0.6 left tc rgb "#BE5400" front
}
plot ARG3 using "across_mm":"up_mm" with filledcurves y1=-14 fc rgb light, \
     ARG1 using "across_mm":"up_mm" with filledcurves y1=8.1 fc rgb "#CFE3F0", \
     ARG3 using "across_mm":"up_mm" with lines lt 1 lw 2, \
     ARG1 using "across_mm":"up_mm" with lines lw 2 dt solid lc rgb blue
do for [i=1:9] { unset label i }
do for [i=1:4] { unset arrow i }

set tmargin at screen 0.615
set bmargin at screen 0.465
set border 3
set xtics nomirror 5 format ""
set ytics nomirror 50
set yrange [-40:120]
set ylabel "gap, µm"
set label 2 "overlap" at -31.6,-22 left tc rgb "#BE5400" front
set arrow 1 from graph 0, first 0 to graph 1, first 0 nohead ls guide
plot ARG4 using "across_mm":(column("gap_um") < 0 ? column("gap_um") : 0) with filledcurves y1=0 fc rgb "#F6D3BF", \
     ARG4 using "across_mm":"gap_um" with lines lt 1 lw 2
unset label 2
unset arrow 1

set tmargin at screen 0.44
set bmargin at screen 0.085
set xtics nomirror 5 format "%g"
set xlabel "across the track, from the middle of the rail, mm"
set ylabel "along the track, mm"
set ytics nomirror 5
set yrange [-17.5:4.3]
set label 2 "pressure, MPa" at screen 0.995,0.455 right
set cbtics
set colorbox user origin 0.89,0.1 size 0.02,0.32
set label 1 "{/:Italic x}, rolling" at -43.2,-1 left front
set arrow 1 from -44,-4 to -44,1 lw 1.8 lc rgb black size 0.7,20 filled front
plot ARG6 using "across_mm":"along_mm":(0.5*column("dy_mm")):(0.5*column("dx_mm")):"p_MPa" with boxxyerror fs solid 1 noborder fc palette
unset multiplot
