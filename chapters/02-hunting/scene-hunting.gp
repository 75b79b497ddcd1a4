# alt: A freight car in space on two rails: two trucks with orange side frames and blue bolsters, displaced to the same side of the red
# alt: middle line of the track, and the edges of the body above them.
load "style.gp"
set output ARG2
W = 1000; H = 560
load "scene.gp"
set style textbox opaque noborder margins 0.6,0.3
set label 99 "new wheels, 150 ft/s; motions\n40 times enlarged; our profiles" at 20, 516 front
plot ARG1 @picture, \
     ARG3 using "x_px":"y_px":"label" with labels left boxed font ",14"
