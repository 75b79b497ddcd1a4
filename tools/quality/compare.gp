load "style.gp"
set output ARG2
set autoscale xfix
set xlabel "distance, km"
set ylabel "standard deviation in D1, mm"
set yrange [0:*]
set tmargin 3.5
set key above horizontal
plot ARG1 using (0.5e-3*(column("from_m")+column("to_m"))):"before_mm" with steps lt 2 title "first run", \
     ARG1 using (0.5e-3*(column("from_m")+column("to_m"))):"after_mm" with steps lt 3 title "second run"
