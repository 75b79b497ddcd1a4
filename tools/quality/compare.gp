load "style.gp"
set output ARG2
set autoscale xfix
set xlabel "distance, km"
set ylabel "standard deviation in D1, mm"
set yrange [0:*]
set tmargin 3.5
set key above horizontal
km(name) = 1e-3 * column(name)
plot ARG1 using (km("from_m")):"before_mm":(km("to_m") - km("from_m")):(0) with vectors nohead lt 1 title "first run", \
     ARG1 using (km("from_m")):"after_mm":(km("to_m") - km("from_m")):(0) with vectors nohead lt 2 title "second run"
