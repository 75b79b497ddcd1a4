# The invisible point at 1 gives a range to a panel that has no value.
load "style.gp"
set output ARG2
set terminal pngcairo size 920,1100 font "DejaVu Sans,13"
set multiplot layout 6,1
set lmargin 12
set rmargin 17
set tmargin 0.6
set bmargin 0.6
set format x ""
set key outside right center nobox font ",12" samplen 1.5
good(q, v) = (strcol(q) eq "good" ? v : NaN)
less(q, v) = ((strcol(q) eq "degraded" || strcol(q) eq "unreliable") && abs(v) < 100 ? v : NaN)
set ylabel "gage less\n56.5 in, mm"
plot ARG1 using "distance_m":(column("gage_mm") - 1435.1) with lines lt 1 lw 1.2, \
     0 with lines ls guide, \
     ARG1 every ::0::0 using "distance_m":(1) with dots lc rgb "#FFFFFFFF" notitle
set ylabel "crosslevel, mm"
plot ARG1 using "distance_m":"crosslevel_mm" with lines lt 1 lw 1.2, \
     0 with lines ls guide, \
     ARG1 every ::0::0 using "distance_m":(1) with dots lc rgb "#FFFFFFFF" notitle
set ylabel "curvature,\nrad/km"
plot ARG1 using "distance_m":(good("curvature_is", column("curvature_rad_per_km"))) with lines lt 1 lw 1.2, \
     0 with lines ls guide, \
     ARG1 every ::0::0 using "distance_m":(1) with dots lc rgb "#FFFFFFFF" notitle
set ylabel "profile, mm"
plot ARG1 using "distance_m":(less("profile_left_is", column("profile_left_mm"))) with lines dt solid lc rgb "#B0B0B0" lw 1.2 title "not good", \
     ARG1 using "distance_m":(good("profile_left_is", column("profile_left_mm"))) with lines dt solid lc rgb blue lw 1.2 title "left", \
     ARG1 using "distance_m":(good("profile_right_is", column("profile_right_mm"))) with lines dt solid lc rgb red lw 1.2 title "right", \
     0 with lines ls guide, \
     ARG1 every ::0::0 using "distance_m":(1) with dots lc rgb "#FFFFFFFF" notitle
set ylabel "alignment, mm"
plot ARG1 using "distance_m":(less("alignment_left_is", column("alignment_left_mm"))) with lines dt solid lc rgb "#B0B0B0" lw 1.2 title "not good", \
     ARG1 using "distance_m":(good("alignment_left_is", column("alignment_left_mm"))) with lines dt solid lc rgb blue lw 1.2 title "left", \
     ARG1 using "distance_m":(good("alignment_right_is", column("alignment_right_mm"))) with lines dt solid lc rgb red lw 1.2 title "right", \
     0 with lines ls guide, \
     ARG1 every ::0::0 using "distance_m":(1) with dots lc rgb "#FFFFFFFF" notitle
set ylabel "speed, mph"
set format x "%g"
set bmargin 3.2
set xlabel "distance, m"
plot ARG1 using "distance_m":"speed_mph" with lines lt 1 lw 1.2, \
     0 with lines ls guide, \
     ARG1 every ::0::0 using "distance_m":(1) with dots lc rgb "#FFFFFFFF" notitle
unset multiplot
