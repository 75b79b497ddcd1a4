load "style.gp"
set output ARG2
set terminal pngcairo size 1728,1300 font "DejaVu Sans,18"
set multiplot layout 7,1 margins 0.1,0.97,0.075,0.99 spacing 0,0.018
set format x ""
set xrange [0:5280]
set xtics 528
unset key
set macros
draw = 'plot ARG1 using "x_ft":(column(c."_true")) with lines lc rgb "#B8B8B8" dt solid lw 4.5, ARG1 using "x_ft":(column(c)) with lines lc rgb black dt solid lw 1.2'
set ytics 4
set ylabel "gage,\nmm"
c = "gage"
@draw
set ytics 40
set ylabel "crosslevel,\nmm"
c = "crosslevel"
@draw
set ytics 2
set ylabel "curvature,\ndeg/100 ft"
c = "curvature"
set yrange [-5:1]
@draw
set yrange [*:*]
set ytics 20
set ylabel "profile\nleft, mm"
c = "profile_left"
@draw
set ylabel "profile\nright, mm"
c = "profile_right"
@draw
set ylabel "alignment\nleft, mm"
c = "alignment_left"
@draw
set ylabel "alignment\nright, mm"
c = "alignment_right"
set format x "%g"
set xlabel "distance, ft: a mile in 18 in at 1:3520 (synthetic track, 60 mph, typical sensors; grey: truth)"
@draw
unset multiplot
