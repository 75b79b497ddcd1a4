# ARG1, ARG3 to ARG5: describing functions of the four cars; ARG6: branches of the equations, a block a car; ARG7: their special points.
# alt: Four panels, one a car, of amplitude against speed. Each branch rises straight up at its critical speed and bends to the right
# alt: where the flange is met: far with new wheels, little with CN and Heumann wheels. With friction the branch comes down to 60 ft/s.
load "style.gp"
set terminal pngcairo size 740,650 font "DejaVu Sans,12" enhanced background rgb "white"
set output ARG2
W = 740.0; H = 650.0
array file[4] = [ARG1, ARG3, ARG4, ARG5]
array key[4] = ["new", "cn", "heumann", "friction"]
array name[4] = ["new wheels", "CN wheels", "Heumann wheels", "CN wheels, dry friction"]
set multiplot
set xrange [50:245]
set yrange [0:0.75]
set xtics 50
set ytics 0.2
unset key
mark(k, column) = strcol("car") eq key[k] ? column : NaN
do for [k = 1:4] {
  c = (k - 1) % 2; r = (k - 1)/2
  set lmargin at screen (74 + 346*c)/W
  set rmargin at screen (74 + 346*c + 306)/W
  set tmargin at screen (H - 62 - 280*r)/H
  set bmargin at screen (H - 62 - 280*r - 234)/H
  set xlabel (r == 1 ? "speed V, ft/s (100 ft/s = 30.5 m/s)" : "")
  set ylabel (c == 0 ? "largest amplitude A, in" : "") offset 0.5
  unset label
  unset arrow
  set label 1 name[k] at graph 0.97,0.93 right font ",13"
  if (k == 1) {
    set label "full equations" at 172,0.36 tc rgb blue
    set label "describing\nfunctions" at 186,0.535 tc rgb red
    set label "thick: full equations;  thin: describing functions;  solid: stable, dotted: unstable" at screen 74/W, screen (H - 18)/H left
    set label "circle: the branch turns (fold);  square: a second frequency sets in (torus)" at screen 74/W, screen (H - 38)/H left
  }
  plot file[k] using 1:3 with lines lw 1.6 dt solid lc rgb red, \
       file[k] using 1:4 with lines lw 1.6 dt (5,4) lc rgb red, \
       file[k] using 1:5 with lines lw 1.6 dt (5,4) lc rgb red, \
       ARG6 every :::k-1::k-1 using 1:4 with lines lw 3 dt (2,1.6) lc rgb blue, \
       ARG6 every :::k-1::k-1 using 1:5 with lines lw 3 dt (2,1.6) lc rgb blue, \
       ARG6 every :::k-1::k-1 using 1:3 with lines lw 4.5 dt solid lc rgb blue, \
       ARG7 using (mark(k, $2)):3 with points pt 6 ps 0.9 lw 1.3 lc rgb black, \
       ARG7 using (mark(k, $2)):4 with points pt 4 ps 0.9 lw 1.3 lc rgb black, \
       ARG7 using (mark(k, $2)):5 with points pt 8 ps 0.9 lw 1.3 lc rgb black
}
unset multiplot
