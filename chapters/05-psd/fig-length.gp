# alt: Seven panels against the length of the record, 2.5 to 20 km. Above: biases of a few per cent
# alt: for three ways of reading, least for long segments, and the fraction of right classes rising to
# alt: 93 % and more. Below: the scatter falls with the square root of the length, to about 2 % for
# alt: the roughness and 1 % for corner and dip.
load "style.gp"
set terminal pngcairo size 1100,720 font "DejaVu Sans,11.5" enhanced background rgb "white"
set output ARG2
set multiplot layout 2,4 margins 0.07,0.985,0.1,0.93 spacing 0.075,0.12
set logscale x
set xrange [2:25]
set xtics (2.5, 5, 10, 20)
unset key
set datafile missing NaN  # lines go on over the rows of other quantities
ways = "'4096 ft' '512 ft' 'ruler'"
quantities = "A corner B"
titles = "'roughness A' 'corner φ_c' 'dip B'"
shift(i) = 1 + 0.04 * (i - 2)  # so that the bars stand side by side
is(q, w) = strcol("quantity") eq word(quantities, q) && strcol("method") eq word(ways, w)
set ylabel "bias, %"
set arrow 1 from graph 0, first 0 to graph 1, first 0 nohead ls guide
do for [q = 1:3] {
  set title word(titles, q)
  plot for [w = 1:3] ARG1 using (is(q, w) ? column("length_km") * shift(w) : NaN):"bias_percent":"bias_error" \
       with yerrorbars lt w dt solid title word(ways, w)
}
set title "class"
set xlabel "length of record, km"
set ylabel "records with the right class, %"
set key at graph 1.0, graph -0.42 right top samplen 2
set yrange [-3:100]
unset arrow 1
plot for [w = 1:3] ARG3 using (strcol("method") eq word(ways, w) ? column("length_km") * shift(w) : NaN):"right_percent":"error" \
     with yerrorbars lt w dt solid title word(ways, w), \
     ARG3 using (strcol("method") eq word(ways, 1) ? column("length_km") : NaN):"stated_percent" with lines lt 1 title "stated, 4096 ft", \
     NaN with lines dt 2 lc rgb grey title "slope of 1/√length"
unset key
unset title
set xlabel "length of record, km"
set ylabel "scatter, %"
set logscale y
set yrange [0.5:50]
set ytics (0.5, 1, 2, 5, 10, 20, 50)
do for [q = 1:3] {
  plot for [w = 1:3] ARG1 using (is(q, w) ? column("length_km") * shift(w) : NaN):"scatter_percent":"scatter_error" \
       with yerrorbars lt w dt solid title word(ways, w), \
       ARG1 using (is(q, 1) ? column("length_km") : NaN):"stated_percent" with lines lt 1, \
       30 / sqrt(x) with lines dt 2 lc rgb grey
}
unset multiplot
