# alt: A wheel on a rail, three ties with pyramids of ballast below them on the subgrade; beside it
# alt: the same as a chain of four springs: pad, tie, ballast, subgrade.
load "style.gp"
set output ARG2
load "scene.gp"
set style textbox opaque noborder margins 0.6,0.3
plot ARG1 @picture, \
     ARG3 using "x_px":"y_px":"label" with labels left boxed font ",15"
