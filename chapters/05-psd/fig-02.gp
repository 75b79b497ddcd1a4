# alt: Three panels. Left: three lines at multiples of the rail's wavenumber, the first by far the
# alt: highest. Middle: two bell-shaped window spectra, a narrow high one for segments of 1024 ft, a
# alt: wide low one for 256 ft. Right: the three lines with these shapes.
load "style.gp"
set terminal pngcairo size 1400,430
set output ARG2
set multiplot layout 1,3
set lmargin 9
set xlabel "wavenumber φ, cycle/m"
set xrange [0:0.3]
set xtics 0.1
set ylabel "line power Q_n, mm²"
set yrange [0:10]
unset key
set title "(a) lines, b = 10 mm"
plot ARG4 using "phi_cycle_per_m":"Q_mm2" with impulses lt 1 lw 4, \
     ARG4 using "phi_cycle_per_m":"Q_mm2" with points lt 1
set key top right samplen 2
set title "(b) Hann window"
set ylabel "window's spectrum, 1/(cycle/m)"
set yrange [0:220]
set xrange [-0.06:0.06]
set xtics 0.03
plot ARG3 using "phi_cycle_per_m":"W_fine" with lines lt 1 title "1024 ft", \
     ARG3 using "phi_cycle_per_m":"W_broad" with lines lt 2 title "256 ft"
unset key
set title "(c) the lines, seen through the window"
set ylabel "S_z, m²/(cycle/m)"
set logscale y
set format y "10^{%L}"
set yrange [1e-7:1e-2]
set xrange [0:0.3]
set xtics 0.1
plot ARG1 using "phi_cycle_per_m":"S_fine" with lines lt 1, \
     ARG1 using "phi_cycle_per_m":"S_broad" with lines lt 2
unset multiplot
