load "style.gp"
set terminal pngcairo size 1000,700 font "DejaVu Sans,14" enhanced background rgb "white"
set output ARG2
set xlabel "(p/V) dV/dp of the critical speed V"
set lmargin 26
set ytics ()
set grid noytics
set key bottom right
set xrange [-0.75:1.75]
set yrange [-9.7:0.7]
set arrow from 0,graph 0 to 0,graph 1 nohead ls guide
set label 1 "profiles and dampers reconstructed" at graph 0.98,0.24 right tc rgb grey
h = 0.13
plot ARG1 using (column("new")/2):(-$0-0.25):(abs(column("new"))/2):(h):ytic(1) with boxxyerror dt solid lw 1 fc rgb black fs solid 1 title "new wheel", \
     ARG1 using (column("cn")/2):(-$0):(abs(column("cn"))/2):(h) with boxxyerror dt solid lw 1 fc rgb blue fs solid 0.55 border rgb blue title "CN A", \
     ARG1 using (column("heumann")/2):(-$0+0.25):(abs(column("heumann"))/2):(h) with boxxyerror dt solid lw 1 fc rgb red fs solid 0.25 border rgb red title "modified Heumann"
