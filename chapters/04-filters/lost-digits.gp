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
set rmargin 26
set key outside right center nobox font ",10"
at(name) = strcol("formula") eq name ? column("x") : NaN
plot ARG1 using (at("cosine")):"plain" with lines lt 1 title "1 − cos θ", \
     ARG1 using (at("exponential")):"plain" with lines lt 2 title "1 − e^{−κ}", \
     ARG1 using (at("damping")):"plain" with lines lt 3 title "difference of e^{−(σ±w)T}", \
     ARG1 using (at("cosine")):"kept" with lines lt 4 title "2 sin^2(θ/2)", \
     ARG1 using (at("exponential")):"kept" with lines lt 5 title "−expm1(−κ)", \
     ARG1 using (at("damping")):"kept" with lines lt 7 title "e^{−σT} sinh(wT)/w"
