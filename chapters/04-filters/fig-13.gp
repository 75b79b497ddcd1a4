# alt: The gain of three high-pass filters against wavelength. All are 1 for short waves. The chosen one stays at 1 to about 200 feet and falls to 0.14 at 1000 feet.
# alt: Two upright lines mark 150 and 200 feet, the longest waves that count at 90 and at 120 mph.
load "style.gp"
set terminal pngcairo size 740,300 font "DejaVu Sans,11"
set output ARG2
unset key
set logscale x
set xrange [20:5000]
set yrange [0:1.25]
set xlabel "wavelength, ft"
set ylabel "gain of the high-pass H"
set xtics (20, 50, 100, 150, 200, 500, 1000, 2000, 5000)
set rmargin 3
set style arrow 1 nohead ls guide
set label "chosen: mean over 151 ft,\nfour times" at 560,0.56 font ",11"
set label "the chosen\none twice" at 207,0.2 left font ",11" textcolor rgb blue
set label "mean over 301 ft, once" at 25,1.19 font ",11" textcolor rgb "#A84300"
plot ARG3 using "wavelength_ft":(0):(0):(1.2) with vectors arrowstyle 1, \
     ARG3 using ($0 == 0 ? 146 : NaN):(0.55):"what" with labels right font ",10", \
     ARG3 using ($0 == 1 ? 206 : NaN):(0.40):"what" with labels left font ",10", \
     ARG1 using "wavelength_ft":"one_pass" with lines lt 3, \
     ARG1 using "wavelength_ft":"two_stages" with lines lt 2, \
     ARG1 using "wavelength_ft":"chosen" with lines lt 1
