load "style.gp"
set terminal pngcairo size 1400,430
set output ARG2
set multiplot layout 1,2
set lmargin 9
set xrange [-3:3]
set yrange [0:1.15]
set ylabel "density"
set xlabel "descriptor, about its mean"
set key top left title "reconstructed" samplen 2
set label 1 "diffusion" at graph 0.97,0.9 right font ",17"
plot for [i=1:3] ARG1 using (column("t") == word("1 8 64",i) ? column("x") : NaN):"diffusion" with lines lt i title "t = ".word("1 8 64",i)
unset ylabel
set label 1 "viscous blob" at graph 0.97,0.9 right font ",17"
plot for [i=1:3] ARG1 using (column("t") == word("1 8 64",i) ? column("x") : NaN):"blob" with lines lt i title "t = ".word("1 8 64",i)
unset multiplot
