# alt: A truck on rails, seen from the front and the right. A beam ahead of its axle reaches down to the rails with a lateral accelerometer and two gage sensors.
# alt: On the plate above, the floor of the body, stand two vertical accelerometers, an inclinometer and two gyros; thin rods down to the axle and across to the frame are height and sway sensors, and an encoder sits on an axle.
load "style.gp"
set output ARG2
W = 1000; H = 634
load "scene.gp"
set style textbox opaque noborder margins 0.5,0.2
plot ARG1 @picture, \
     ARG3 using "x_px":"y_px":"label" with labels left boxed offset 0.4,0.2 font ",14"
