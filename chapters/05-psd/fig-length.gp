load "style.gp"
set output ARG2
set logscale xy
set xrange [1.5:600]
set yrange [0.3:20]
set xlabel "length of record, km"
set ylabel "standard error of A, %"
set ytics (0.3, 0.5, 1, 2, 5, 10, 20)
set xtics (2, 5, 10, 20, 50, 100, 200, 500)
names = "1 10 13"
set arrow from graph 0, first 5 to graph 1, first 5 nohead ls guide
plot for [i = 1:3] ARG1 using (strcol("zone") eq word(names, i) ? column("length_km") : NaN):"error_percent" \
       with lines lt i title "zone ".word(names, i).", claimed", \
     for [i = 1:3] ARG3 using (strcol("zone") eq word(names, i) ? column("length_km") : NaN):"scatter_percent":"low_percent":"high_percent" \
       with yerrorbars lt i dt solid title "zone ".word(names, i).", scatter of records"
