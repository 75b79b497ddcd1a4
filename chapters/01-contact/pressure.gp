load "style.gp"
set output ARG2
H = 560
load "scene.gp"
set style textbox opaque noborder margins 0.6,0.3
set cblabel "pressure, 10^5 psi" offset 0.5,0
set cbrange [0:3.01]
plot ARG1 @picture, \
     ARG3 using "x_px":"y_px":"label" with labels left boxed font ",14", NaN with points palette
