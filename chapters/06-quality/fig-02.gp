# alt: The gain of the stroke against wavelength on logarithmic axes. It is 1 for waves of a few metres, peaks at 2.6 near 55 m and falls with the square of the wavelength beyond.
load "style.gp"
set terminal pngcairo size 740,350 font "DejaVu Sans,11"
set output ARG2
unset key
set logscale xy
set xrange [1:1000]
set yrange [0.002:10]
set format y "%g"
set xlabel "wavelength λ, m"
set ylabel "stroke over track amplitude |X/Z|"
set logscale x2
set x2range [1:0.001]
set x2tics ("1" 1, "0.1" 0.1, "0.01" 0.01, "0.001" 0.001)
set x2label "spatial frequency φ, cycle/m" offset 0,-0.4
set tmargin 4.5
set rmargin 3.5
set arrow from 1,1 to 1000,1 nohead ls guide
set label "peak as printed, 55 m" at 62,3.2 font ",10" textcolor rgb "#A84300"
set label "short waves:\nthe body stays,\nthe stroke is the wave" at 1.3,0.45 font ",10"
set label "long waves:\nthe body follows" at 330,0.25 font ",10"
plot ARG1 using "wavelength_m":"gain" with lines lt 1, \
     ARG3 using "wavelength_m":"gain" with points ls printed
