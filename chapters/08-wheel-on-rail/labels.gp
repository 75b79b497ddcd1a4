load "style.gp"
set output ARG2
load "scene.gp"
set style textbox opaque noborder margins 0.6,0.3
plot ARG1 @picture, \
     ARG3 using "x_px":"y_px":"label" with labels left boxed font ",15"
