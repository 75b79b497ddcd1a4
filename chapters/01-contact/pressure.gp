# alt: Columns as high as the pressure stand over the rear half of the contact and rise from the left to a ridge at the right end, where they fall off; the front half shows the mesh, and a closed line around both is the interpenetration curve.
load "style.gp"
set output ARG2
H = 560
load "scene.gp"
set style textbox opaque noborder margins 0.6,0.3
set cblabel "pressure, 10^5 psi" offset 0.5,0
set cbrange [0:3.01]
plot ARG1 @picture, \
     ARG3 using "x_px":"y_px":"label" with labels left boxed font ",14", NaN with points palette
