# alt: A piece of a wheel's surface seen from below. A round patch of low pressure lies on the tread, a slender one of high pressure on the slope to the flange; lines of traction point across the wheel.
load "style.gp"
set output ARG2
W = 1000
H = 560
load "scene.gp"
set cblabel "pressure, MPa"
set cbrange [0:1600]  # as in patches.cpp
set style textbox opaque noborder margins 0.6,0.3
plot ARG1 @picture, NaN with points palette, \
     ARG3 using "x_px":"y_px":"label" with labels left boxed font ",15"
