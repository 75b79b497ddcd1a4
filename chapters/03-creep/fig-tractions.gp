load "style.gp"
set output ARG2
set terminal pngcairo size 1400,520
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
do for [k=1:5] {
  left = 0.012 + 0.182 * (k - 1)
  set lmargin at screen left
  set rmargin at screen left + 0.172
  set tmargin at screen 0.93
  set bmargin at screen 0.55
  set title name[k]
  unset xlabel
  set format x ""
  if (k == 5) { set colorbox user origin 0.93,0.56 size 0.012,0.3; set label 3 "|p| / μp_0" at screen 0.925,0.91 front } else { unset colorbox }
  plot file[k] using "x":"y":(1.03*column("dx")):(1.03*column("dy")):"p" with boxxyerror fillstyle solid 1.0 noborder palette, \
       file[k] using (column("arrow") > 0 ? column("x") : NaN):"y":(0.17*column("px")):(0.17*column("py")) with vectors lc rgb "white" lw 1.6 head filled size 0.05,20
  unset title
  unset label 3
  unset colorbox
  set tmargin at screen 0.53
  set bmargin at screen 0.15
  set format x "%g"
  set xlabel "x/a, rolling →" offset 0,0.3
  if (k == 5) { set label 1 "sticks" at screen 0.94,0.34 tc rgb blue front; set label 2 "slides" at screen 0.94,0.28 tc rgb orange front }
  plot file[k] using "x":"y":(1.03*column("dx")):(1.03*column("dy")):(column("stick") > 0 ? 0x0072B2 : 0xE69F00) with boxxyerror fillstyle solid 1.0 noborder lc rgb variable
}
unset multiplot
