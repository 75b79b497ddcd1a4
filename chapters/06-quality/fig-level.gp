# alt: Allowed amplitude against wavelength at 100 km/h. Without stops it is level at 1 cm. With stops as stiff as the spring it is level a little lower. With stops ten and a hundred times as stiff it has two levels, the lower one for waves below some 10 and 3.5 m.
load "style.gp"
set terminal pngcairo size 740,350 font "DejaVu Sans,11"
set output ARG2
unset key
set logscale xy
set xrange [1:300]
set yrange [0.1:100]
set format y "%g"
set rmargin 2
set xlabel "wavelength λ, m"
set ylabel "allowed amplitude, cm"
set label "no stops, κ = 0" at 1.15,1.25 font ",10"
set label "κ = 1" at 1.15,0.72 font ",10" textcolor rgb blue
set label "κ = 10" at 1.15,0.32 font ",10" textcolor rgb "#A84300"
set label "κ = 100" at 4,0.145 font ",10" textcolor rgb "#00694B"
set label "dotted: harmonic balance,\none swing a wave" at 1.15,30 font ",10"
set label "every third wave\nkeeps the body\nswinging" at 6.2,0.52 center font ",10"
unset label 6
plot for [i=1:4] ARG1 using (column("kappa") == word("0 1 10 100",i) ? column("wavelength_m") : NaN):"amplitude_cm" \
     with lines lt i dt 1, \
     for [i=2:4] ARG3 using (column("kappa") == word("0 1 10 100",i) ? column("wavelength_m") : NaN):"amplitude_cm" \
     with lines lt i lw 1.2 dt 3
