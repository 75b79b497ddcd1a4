load "style.gp"
set output ARG2
set logscale xy
set xlabel "foundation modulus K of one rail, psi"
set ylabel "stiffness under one wheel K_r, MN/m"
set xrange [200:8000]
set yrange [5:120]
set xtics (200,500,1000,1500,2000,3000,5000,8000)
set ytics (5,10,20,50,100)
set key top left
set object 1 rectangle from 1500,5 to 3000,120 fc rgb "#EEEEEE" fs solid noborder behind
set label "maintained\nmain line" at 2120,7 center tc rgb "#606060"
plot for [i = 2:5] ARG1 using 1:i with lines lt i-1 title word("115RE 119RE 132RE 136RE", i-1), \
     ARG3 using 1:2 with points ls other title "typical track (assumed)"
