# alt: Two spectra of cross level that fall with growing wavenumber on logarithmic axes, class 3
# alt: above class 6; four marks at the top show where staggered joints add power.
load "style.gp"
set output ARG2
set logscale xyx2
set xlabel "wavenumber, cycles/ft"
set x2label "wavelength, m"
set ylabel "spectrum of cross level, in^2/(cycle/ft)"
set format y "10^{%T}"
set xrange [0.002:0.5]
set yrange [1e-6:1]
set x2range [0.002:0.5]
set xtics nomirror
set x2tics ("100" 0.003048, "50" 0.006096, "20" 0.01524, "10" 0.03048, "5" 0.06096, "2" 0.1524, "1" 0.3048)
set tmargin 4
set border 7
set key bottom left
plot ARG3 using 1:(0.5) with points pt 11 ps 1.6 lc rgb red title "odd harmonics of 39-ft rails", \
     ARG1 using 1:3 with lines lt 2 title "class 3", \
     ARG1 using 1:2 with lines lt 1 title "class 6"
