# alt: Largest deflection against speed. Without damping it grows without bound at the critical
# alt: speed; with dampings of 0.05, 0.2 and 0.4 it peaks at 3.8, 1.8 and 1.25 and falls beyond;
# alt: with 1 it falls from the start. Marks at 150 and 250 mph lie near 1.
load "style.gp"
set terminal pngcairo size 1000,470
set output ARG2
set xlabel "speed over critical speed, θ = V / V_c"
set ylabel "largest deflection / static deflection"
set xrange [0:2.5]
set yrange [0:5]
set key at 2.48,4.85 top right Left reverse width -2
set arrow from 1,0 to 1,5 nohead ls guide
set label "no damping:\n1/√(1−θ^2)" at 0.88,3.9 right
set label "ζ = 0.05" at 1.1,3.1 tc rgb blue
set label "ζ = 0.2" at 1.02,1.46 tc rgb red
set label "ζ = 0.4" at 1.02,0.92 tc rgb green
set label "ζ = 1" at 1.02,0.42 tc rgb purple
set label "150" at 0.11,1.35 center tc rgb red
set label "250" at 0.24,1.35 center tc rgb red
set label "150" at 0.235,0.6 center tc rgb green
set label "250" at 0.387,0.6 center tc rgb green
plot ARG3 using 1:2 with lines lt 1, \
     ARG1 using 1:2 with lines lt 2, \
     ARG1 using 1:3 with lines lt 3, \
     ARG1 using 1:4 with lines lt 4, \
     ARG1 using 1:5 with lines lt 5, \
     ARG4 using 1:2 with points ls printed title "150 and 250 mph if V_c = 1100 mph", \
     ARG5 using 1:2 with points ls other title "150 and 250 mph on the typical track"
