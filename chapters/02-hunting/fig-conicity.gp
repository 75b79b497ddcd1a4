load "style.gp"
set output ARG2
set xlabel "amplitude, mm"
set ylabel "equivalent conicity"
set xrange [0:19.05]
set yrange [0:1.2]
set label "profiles reconstructed" at graph 0.98,1.03 right tc rgb red
set key left top reverse Left
plot ARG1 using 1:"heumann" with lines lt 3 dt solid title "Heumann, by wavelength", \
     ARG1 using 1:"heumann_harmonic" with lines lt 3 lw 1.4 dt (4,4) title "first harmonic", \
     ARG1 using 1:"cn" with lines lt 2 dt solid title "CN, by wavelength", \
     ARG1 using 1:"cn_harmonic" with lines lt 2 lw 1.4 dt (4,4) title "first harmonic", \
     ARG1 using 1:"new" with lines lt 1 dt solid title "new wheel, by wavelength", \
     ARG1 using 1:"new_harmonic" with lines lt 1 lw 1.4 dt (4,4) title "first harmonic"
