load "style.gp"
set output ARG2
set logscale xy
set xrange [0.005:1.5]
set yrange [0.5:200]
set xlabel "wavenumber, cycle/m"
set ylabel "spectrum found / spectrum there"
set key top left
set arrow from graph 0, first 1 to graph 1, first 1 nohead ls guide
names = "boxcar-constant boxcar-linear hamming dpss blackman-harris hann"
array said[6] = ["no window, mean off", "no window, line off", "Hamming", "Slepian (DPSS)", "Blackman-Harris", "Hann"]
array type[6] = [1, 2, 3, 6, 5, 4]
plot for [i = 1:6] ARG1 using (strcol("window") eq word(names, i) ? column("phi_cycle_per_m") : NaN):"ratio" \
     with linespoints lt type[i] lw (i == 4 ? 6 : i == 5 ? 3.5 : 2) ps (i == 4 ? 1.6 : 0.7) title said[i]
