# alt: Above, a chain of six boxes joined by arrows: track and car, sensor, analog filter B, sample each foot, digital filter C, curvature.
# alt: An encoder under the sampler gives the time of each foot to it and to the digital filter.
# alt: Below left, the weight with which an analog filter alone remembers the track behind the sample: over some two feet at 9 mph and tens of feet at 80 mph.
# alt: Below right, the weight behind the digital filter: a box over the last foot at both speeds, slightly tilted at 9 mph, and nothing beyond.
load "style.gp"
set output ARG2
set terminal pngcairo size 740,480 font "DejaVu Sans,11"
set multiplot
# The chain, in pixels from the lower left corner.
set lmargin at screen 0
set rmargin at screen 1
set bmargin at screen 0
set tmargin at screen 1
set xrange [0:740]
set yrange [0:480]
unset border
unset tics
unset grid
unset key
array X[6] = [4, 130, 228, 362, 476, 634]
array W[6] = [98, 70, 102, 82, 126, 102]
do for [i=1:6] {
  set object i rectangle from X[i],420 to X[i]+W[i],476 fc rgb "#EEF3F8" fs solid border lc rgb "#404040" lw 1.4
}
set label 1 "track under\na moving car" at 53,457 center font ",10"
set label 2 "sensor" at 165,449 center font ",10"
set label 3 "analog filter\nB, corner ω_1" at 279,457 center font ",10"
set label 4 "sample\neach foot" at 403,457 center font ",10"
set label 5 "digital filter C,\nknows ω_1 and T_k" at 539,457 center font ",10"
set label 6 "curvature\nof the track" at 685,457 center font ",10"
set style arrow 1 filled size 9,20,60 lw 1.6 lc rgb "#404040"
do for [i=1:5] { set arrow i from X[i] + W[i] + 2,448 to X[i + 1] - 2,448 arrowstyle 1 }
set label 11 "x(t)" at 214,464 center font ",10" textcolor rgb blue
set label 12 "y(t)" at 346,464 center font ",10" textcolor rgb blue
set label 13 "y_k" at 460,464 center font ",10" textcolor rgb blue
set label 14 "u_k" at 618,464 center font ",10" textcolor rgb blue
set object 7 rectangle from 328,344 to 478,388 fc rgb "#F4F2EC" fs solid border lc rgb "#404040" lw 1.4
set label 7 "encoder on the axle:\ntime T_k of each foot" at 403,374 center font ",10"
set arrow 7 from 403,389 to 403,418 arrowstyle 1
set arrow 8 from 479,366 to 539,366 nohead lw 1.6 lc rgb "#404040"
set arrow 9 from 539,366 to 539,418 arrowstyle 1
set label 15 "works in seconds" at 279,406 center font ",10" textcolor rgb "#7A4B00"
set label 16 "works in feet" at 650,406 center font ",10" textcolor rgb "#7A4B00"
plot NaN
do for [i=1:9] { unset object i; unset arrow i }
do for [i=1:16] { unset label i }
# The weights.
set border 3
set tics nomirror out scale 0.75 font ",10"
set grid xtics ytics back lc rgb "#CCCCCC" lw 1 dt solid
set bmargin at screen 0.13
set tmargin at screen 0.585
set xlabel "distance before the sample, ft" font ",10" offset 0,0.3
set ylabel "weight of a foot of track" font ",10" offset 1.4,0
set yrange [0:1.35]
set ytics 0.5 nomirror
set lmargin at screen 0.1
set rmargin at screen 0.485
set xrange [8:0]
set xtics 2 nomirror
set label 1 "memory of y_k: analog filter alone" at graph 0.5,1.1 center font ",10"
set label 2 "80 mph" at 6.2,0.12 center font ",10" textcolor rgb "#A84300"
set label 3 "9 mph" at 1.8,0.34 right font ",10" textcolor rgb blue
plot ARG1 using "back_ft":"analog_9" with filledcurves y=0 fc rgb blue fs transparent solid 0.12 noborder, \
     ARG1 using "back_ft":"analog_80" with lines lt 3, ARG1 using "back_ft":"analog_9" with lines lt 2
set lmargin at screen 0.59
set rmargin at screen 0.985
set xrange [8:0]
set xtics 2 nomirror
unset ylabel
set label 1 "memory of u_k: both filters" at graph 0.5,1.1 center font ",10"
set label 2 "80 mph" at 1.25,1.00 right font ",10" textcolor rgb "#A84300"
set label 3 "9 mph" at 1.25,0.72 right font ",10" textcolor rgb blue
set label 4 "nothing" at 4.5,0.12 center font ",10"
plot ARG1 using "back_ft":"hybrid_9" with filledcurves y=0 fc rgb blue fs transparent solid 0.12 noborder, \
     ARG1 using "back_ft":"hybrid_80" with lines lt 3, ARG1 using "back_ft":"hybrid_9" with lines lt 2
unset multiplot
