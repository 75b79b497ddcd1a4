load "style.gp"
set output ARG2
H = 600
load "scene.gp"
set style textbox opaque noborder margins 0.6,0.3
set label "lines: the bound μp_n along both axes, and the rim" at graph 0.02,0.96 front font ",16"
plot ARG1 binary filetype=png flipy with rgbimage, \
     ARG3 using "x_px":"y_px":"label" with labels center boxed font ",16"
