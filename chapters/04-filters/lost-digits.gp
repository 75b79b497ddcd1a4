# alt: Relative error against the argument on logarithmic axes. The three forms that subtract rise towards small arguments, the cosine twice as steeply, up to an error of one. The three forms that are used lie together at the bottom, at rounding.
load "style.gp"
set terminal pngcairo size 740,400 font "DejaVu Sans,11"
set output ARG2
set logscale xy
set format "10^{%T}"
set xlabel "argument"
set ylabel "relative error"
set xrange [1e-8:1]
set yrange [1e-17:10]
set rmargin 22
unset key
at(name) = strcol("formula") eq name ? column("x") : NaN
set label 1 "1 − cos θ" at 3e-6,1e-4 font ",11"
set label 2 "1 − e^{−κ}" at 1.2e-8,3e-11 font ",11" textcolor rgb blue
set arrow 3 from 1e-6,1.2e-14 to 1e-6,5e-11 nohead lw 1 lc rgb "#A84300"
set label 3 "(e^{−(σ−w)T} − e^{−(σ+w)T}) / 2w" at 6e-8,2.5e-15 font ",11" textcolor rgb "#A84300"
set label 4 "2 sin^2(θ/2)" at graph 1.02,0.20 left font ",11"
set label 5 "−expm1(−κ)" at graph 1.02,0.04 left font ",11" textcolor rgb blue
set label 6 "e^{−σT} sinh(wT) / w" at graph 1.02,0.12 left font ",11" textcolor rgb "#A84300"
plot ARG1 using (at("cosine")):"plain" with lines lt 1 dt 1, \
     ARG1 using (at("exponential")):"plain" with lines lt 2 dt 1, \
     ARG1 using (at("damping")):"plain" with lines lt 3 dt 1, \
     ARG1 using (at("cosine")):"kept" with lines lt 1 dt (6,4), \
     ARG1 using (at("exponential")):"kept" with lines lt 2 dt (6,4), \
     ARG1 using (at("damping")):"kept" with lines lt 3 dt (6,4)
