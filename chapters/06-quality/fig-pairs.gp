load "style.gp"
set output ARG2
set xrange [-0.1:0.1]
set yrange [1.7:2.15]
set key top right title "stops reconstructed, κ = 10" maxrows 2
set xlabel "n_1 f_1 − n_2 f_2, Hz"
set ylabel "worst stroke, cm"
plot for [i=1:4] ARG1 using (column("n1") == word("1 1 2 3",i) && column("n2") == word("2 3 3 1",i) ? column("detuning_Hz") : NaN):"stroke_cm" \
     with linespoints lt i title sprintf("(%s, %s)", word("1 1 2 3",i), word("2 3 3 1",i)), \
     ARG3 using "detuning_Hz":"stroke_cm" with lines ls guide title "one sine"
