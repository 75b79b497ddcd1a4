load "style.gp"
set terminal pngcairo size 1000,800 font "DejaVu Sans,14" enhanced background rgb "white"
set output ARG2
set multiplot layout 2,2
set xrange [0:250]
set yrange [0:0.75]
set xtics 50
set tmargin 2.5
array name[4] = ["new wheel", "CN A", "modified Heumann", "CN A with friction"]
set label 1 "data reconstructed" at graph 0.98,0.95 right tc rgb grey font ",11"
do for [k=1:4] {
  file = k == 1 ? ARG1 : k == 2 ? ARG3 : k == 3 ? ARG4 : ARG5
  set title name[k]
  if (k == 3) { set key at graph 0.98,0.3 right top } else { unset key }
  set xlabel k > 2 ? "speed V, ft/s" : ""
  set ylabel k % 2 ? "largest amplitude A, in" : ""
  plot file index 0 using 1:2 with lines lt 1 title "first", \
       file index 1 using 1:2 with lines lt 3 title "second"
}
unset multiplot
