load "style.gp"
set output ARG2
set key bottom left
set logscale xy
set xrange [1:1000]
set yrange [0.002:10]
set format y "%g"
set xlabel "wavelength, m"
set ylabel "stroke over track amplitude |X/Z|"
set logscale x2
set x2range [1:0.001]
set x2tics ("1" 1, "0.1" 0.1, "0.01" 0.01, "0.001" 0.001)
set x2label "spatial frequency, cycle/m"
set tmargin 5
set arrow from 1,1 to 1000,1 nohead ls guide
plot ARG1 using "wavelength_m":"gain" with lines lt 1 title "|X/Z|, 0.5 Hz, damping 0.2, 100 km/h", \
     ARG3 using "wavelength_m":"gain" with points ls printed title "peak as printed"
