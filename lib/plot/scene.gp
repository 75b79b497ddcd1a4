# Labels over a rendered picture (lib/scene), pixel for pixel. After style.gp and `set output ARG2`:
#
#   load "scene.gp"
#   set cblabel "pressure, psi"; set cbrange [0:40000]     (only for a colour bar)
#   plot ARG1 @picture, ARG3 using "x_px":"y_px":"label" with labels
#
# ARG1 is the PNG of scene::render, twice 1000 by 650 or what `W = 800; H = 600` set before says; ARG3 a CSV of
# scene::project's pixels. x runs from the left edge, y from the top edge down. A bar of colours shows when
# the plot has a palette element: add `, NaN with points palette`, and render 860 pixels wide to leave it room.
# Labels with a comma in them need quotes in the CSV.
if (!exists("W")) W = 1000
if (!exists("H")) H = 650
set terminal pngcairo size W,H font "DejaVu Sans,14" enhanced background rgb "white"
unset border
unset tics
unset grid
unset key
set lmargin at screen 0
set rmargin at screen 1
set tmargin at screen 1
set bmargin at screen 0
set xrange [-0.5:W-0.5] # the picture has its pixels at whole numbers
set yrange [H-0.5:-0.5]
set cbtics
set colorbox user origin graph 0.89, graph 0.2 size graph 0.02, graph 0.6 front
picture = "binary filetype=png flipy dx=0.5 dy=0.5 origin=(-0.25,-0.25) with rgbimage"
