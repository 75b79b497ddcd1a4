load "style.gp"
set output ARG2
set xlabel "across the track from the rail's origin, mm"
set ylabel "along the track, mm"
set cblabel "pressure, MPa"
set rmargin 18
set cblabel offset 2
unset key
set size ratio -1
plot ARG1 using 1:2:3 with points pt 7 ps 0.4 palette
