load "style.gp"
set output ARG2
W = 1200; H = 760
load "scene.gp"
set style textbox opaque noborder margins 0.5,0.2
plot ARG1 @picture, \
     ARG3 using "x_px":"y_px":"label" with labels left boxed offset 0.4,0.2 font ",14"
