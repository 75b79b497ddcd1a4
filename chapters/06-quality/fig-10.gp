# alt: Two panels with the same logarithmic axes. Left, normal histograms at three times spread to ever wider parabolas without an end. Right, those of the blob have vertical edges, which move outwards.
load "style.gp"
set terminal pngcairo size 740,330 font "DejaVu Sans,11"
set minussign
set output ARG2
unset key
set multiplot layout 1,2
set rmargin 1.5
set lmargin 9.5
set logscale y
set xrange [-3:3]
set yrange [1e-4:3]
set format y "10^{%T}"
set ylabel "density"
set xlabel "descriptor p"
set label 1 "diffusion" at graph 0.04,0.95 font ",11"
set label 2 "t = 1" at 0,0.12 center font ",10"
set label 3 "8" at 1.45,0.04 font ",10" textcolor rgb blue
set label 4 "64" at 2.35,0.1 font ",10" textcolor rgb "#A84300"
plot for [i=1:3] ARG1 using (column("t") == word("1 8 64",i) ? column("x") : NaN):"diffusion" with lines lt i dt 1
unset ylabel
set label 1 "viscous blob"
set label 2 at 0,0.12
set label 3 at 0.98,0.02
set label 4 at 1.75,0.1
plot for [i=1:3] ARG1 using (column("t") == word("1 8 64",i) ? column("x") : NaN):(column("blob") > 0 ? column("blob") : 1e-9) with lines lt i dt 1
unset multiplot
