load "style.gp"
set output ARG2
set terminal pngcairo size 1100,1030
set multiplot
unset key
set size ratio -1
set xrange [-1.06:1.06]
set yrange [-0.72:0.72]
set xtics -1,1,1
unset ytics
unset grid
set cbrange [0:1]
array file[5] = [ARG3, ARG4, ARG5, ARG6, ARG7]
array name[5]
stats ARG1 using (name[int($0)+1] = stringcolumn(1), 0) nooutput
# Three states above, two and the legend below; under each its stick and slip.
do for [k=1:5] {
  left = 0.02 + 0.325 * ((k - 1) % 3)
  top = k > 3 ? 0.465 : 0.955
  set lmargin at screen left
  set rmargin at screen left + 0.305
  set tmargin at screen top
  set bmargin at screen top - 0.19
  set title name[k] offset 0,-0.5
  unset xlabel
  set format x ""
  if (k == 5) { set colorbox user origin 0.72,0.26 size 0.018,0.16; set label 3 "|p| / μp_0" at screen 0.72,0.44 front } else { unset colorbox }
  plot file[k] using "x":"y":(1.03*column("dx")):(1.03*column("dy")):"p" with boxxyerror fillstyle solid 1.0 noborder palette, \
       file[k] using (column("arrow") > 0 ? column("x") : NaN):"y":(0.17*column("px")):(0.17*column("py")) with vectors lc rgb "white" lw 1.8 head filled size 0.05,20
  unset title
  unset label 3
  unset colorbox
  set tmargin at screen top - 0.20
  set bmargin at screen top - 0.39
  set format x "%g"
  set xlabel "x/a, rolling →" offset 0,0.5
  if (k == 5) { set label 1 "■ sticks" at screen 0.72,0.17 tc rgb blue front; set label 2 "■ slides" at screen 0.72,0.13 tc rgb orange front }
  plot file[k] using "x":"y":(1.03*column("dx")):(1.03*column("dy")):(column("stick") > 0 ? 0x0072B2 : 0xE69F00) with boxxyerror fillstyle solid 1.0 noborder lc rgb variable
}
unset multiplot
