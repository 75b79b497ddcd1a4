load "style.gp"
set output ARG2
set terminal pngcairo size 1300,560
set multiplot layout 1,2
set xlabel "wheel load, kip"
set xrange [0:100]
set ylabel "loss of stiffness under the wheel, %"
set yrange [0:2]
set key top left
set arrow from 27.5,0 to 27.5,2 nohead ls guide
set label "27.5 kip" at 28.5,1.3 tc rgb "#606060"
plot ARG1 using "load_kip":"stiffness_loss_percent" with lines lt 1 title "bed that cannot pull"
unset arrow
unset label
set ylabel "largest uplift of the rail, mm"
set yrange [0:*]
set arrow from 27.5,graph 0 to 27.5,graph 1 nohead ls guide
plot ARG1 using "load_kip":"uplift_mm" with lines lt 1 title "bed that cannot pull", \
     ARG1 using "load_kip":"linear_uplift_mm" with lines lt 2 title "equation (1)'s, on ties"
unset multiplot
