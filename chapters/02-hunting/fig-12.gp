# Mode shapes with new wheels. ARG1: the first family, ARG3: the second.
# alt: Amplitudes of the motions and the frequency against amplitude, for two families. All lines are level up to 0.4 in and then jump:
# alt: the body comes to rest in the first family, front truck and body in the second; warp and frequency grow.
load "style.gp"
set terminal pngcairo size 740,560 font "DejaVu Sans,12" enhanced background rgb "white"
set output ARG2
W = 740.0; H = 560.0
array file[2] = [ARG1, ARG3]
array name[2] = ["first family: together", "second: opposed, then fishtailing"]
set multiplot
set xrange [0:0.75]
set xtics 0.2
unset key
do for [k = 1:2] {
  set lmargin at screen (78 + 352*(k - 1))/W
  set rmargin at screen (78 + 352*(k - 1) + 264)/W
  unset xlabel
  unset label
  set format x ""
  # lateral motions
  set tmargin at screen (H - 28)/H
  set bmargin at screen (H - 185)/H
  set yrange [0:1.25]
  set ytics 0.5
  set ylabel (k == 1 ? "amplitude / X_{TR}" : "") offset 1
  set label 1 name[k] at graph 0,1.09 left font ",13"
  set label 2 "X_{TF}" at (k == 1 ? 0.6 : 0.1),(k == 1 ? 1.13 : 0.68) tc rgb black
  set label 3 "X_C" at (k == 1 ? 0.46 : 0.1),(k == 1 ? 0.14 : 0.32) tc rgb blue
  plot file[k] using "A_in":"X_TF" with lines lt 1, \
       file[k] using "A_in":"X_C" with lines lt 2
  unset label
  # angles
  set tmargin at screen (H - 205)/H
  set bmargin at screen (H - 362)/H
  set yrange [0:0.45]
  set ytics 0.2
  set ylabel (k == 1 ? "rad per ft of X_{TR}" : "") offset 1
  set label 1 "θ_{WR}" at 0.775,0.38 tc rgb blue
  set label 2 "θ_{TR}" at 0.775,0.15 tc rgb black
  set label 3 "θ_C" at 0.775,(k == 1 ? 0.075 : 0.015) tc rgb red
  set label 4 "φ_C" at 0.775,(k == 1 ? 0.01 : 0.083) tc rgb green
  plot file[k] using "A_in":"TH_TR" with lines lt 1, \
       file[k] using "A_in":"TH_WR" with lines lt 2, \
       file[k] using "A_in":"TH_C" with lines lt 3, \
       file[k] using "A_in":"PHI_C" with lines lt 4
  unset label
  # frequency
  set tmargin at screen (H - 382)/H
  set bmargin at screen (H - 500)/H
  set yrange [0:40]
  set ytics 20
  set format x "%g"
  set ylabel (k == 1 ? "ω, rad/s" : "") offset 1
  set xlabel "largest amplitude A, in" offset 0,0.3
  plot file[k] using "A_in":"omega" with lines lt 1
}
unset multiplot
