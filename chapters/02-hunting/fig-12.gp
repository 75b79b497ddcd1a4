load "style.gp"
set terminal pngcairo size 900,640 font "DejaVu Sans,14" enhanced background rgb "white"
set output ARG2
set multiplot layout 3,1
set tmargin 1.6
set bmargin 3.2
set xrange [0:0.75]
set lmargin 10
set rmargin 4
set key horizontal nobox reverse Left
set ylabel "over X_{TR}"
set yrange [0:1.6]
set ytics 0.4
set label 1 "thick: first family   thin: second family (fishtailing)" at graph 0.98,1.08 right tc rgb grey
set key at graph 0.98,0.55 right top
plot ARG1 using "A_in":"X_TF" with lines lt 1 title "X_{TF}", \
     ARG1 using "A_in":"X_C" with lines lt 2 title "X_C", \
     ARG3 using "A_in":"X_TF" with lines lt 1 lw 1, \
     ARG3 using "A_in":"X_C" with lines lt 2 lw 1
unset label 1
set key at graph 0.02,0.97 left top maxcols 2
set ylabel "rad/ft of X_{TR}"
set yrange [0:0.5]
set ytics 0.1
plot ARG1 using "A_in":"TH_TR" with lines lt 1 title "θ_{TR}", \
     ARG1 using "A_in":"TH_WR" with lines lt 2 title "θ_{WR}", \
     ARG1 using "A_in":"TH_C" with lines lt 3 title "θ_C", \
     ARG1 using "A_in":"PHI_C" with lines lt 4 title "φ_C", \
     ARG3 using "A_in":"TH_TR" with lines lt 1 lw 1, \
     ARG3 using "A_in":"TH_WR" with lines lt 2 lw 1, \
     ARG3 using "A_in":"TH_C" with lines lt 3 lw 1, \
     ARG3 using "A_in":"PHI_C" with lines lt 4 lw 1
set ylabel "ω, rad/s"
set xlabel "largest wheelset amplitude A, in" offset 0,0.4
set yrange [0:40]
set ytics 10
plot ARG1 using "A_in":"omega" with lines lt 1, \
     ARG3 using "A_in":"omega" with lines lt 1 lw 1
unset multiplot
