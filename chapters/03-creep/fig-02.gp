# alt: The small wheel seen from above on the rim of the big one, turned by the angle of attack. The friction force along the turned wheel has a longitudinal part and an axial part.
load "style.gp"
set output ARG2
set terminal pngcairo size 740,240 font "DejaVu Sans,12" enhanced background rgb "white"
stats ARG1 using "attack_degree" name "t" nooutput
t = t_max*pi/180
unset grid
unset key
unset border
unset tics
set lmargin 0
set rmargin 0
set tmargin 0
set bmargin 0
set size ratio -1
set xrange [-13:34]
set yrange [-7.5:7.5]
set style fill solid 0.5 noborder
c = cos(t); s = sin(t)
set arrow 1 from 0,0 to 9,0 lw 2 lc rgb black size 0.5,20 filled front
set label 1 "longitudinal ({/:Italic z} in the paper)" at 9.4,-0.4 left front
set arrow 2 from 0,0 to 0,-6 lw 2 lc rgb black size 0.5,20 filled front
set label 2 "axial ({/:Italic y} in the paper)" at 0.5,-6.3 left front
set object 1 circle at 0,0 size 0.45 fc rgb "white" fs solid border lc rgb black lw 2 front
set label 9 "×" at 0,0 center front
set label 3 "load {/:Italic N}, into the page\n({/:Italic x} in the paper)" at -10.6,-5.9 left front
set arrow 3 from -3.4,-5.1 to -0.5,-0.4 nohead lw 1 lc rgb "#606060" front
set arrow 4 from 0,0 to 7.6*c,7.6*s lw 3 lc rgb red size 0.6,20 filled front
set label 4 "friction force, along the turned wheel" at 7.9*c,7.6*s+1.2 left textcolor rgb "#BE5400" front
set arrow 5 from 7.6*c,0 to 7.6*c,7.6*s lw 1.6 lc rgb red dt (5,4) size 0.4,20 filled front
set label 5 "its axial part" at 7.6*c+0.7,3.8*s+0.35 left textcolor rgb "#BE5400" front
set object 3 circle at 0,0 size 5 arc [0:t_max] nowedge fs empty border lc rgb blue lw 2 front
set label 6 "angle of attack" at 9.4,-2.3 left textcolor rgb blue front
set arrow 6 from 9.2,-2.3 to 5.05*cos(t/2),5.05*sin(t/2) nohead lw 1 lc rgb blue front
set label 7 "small wheel" at -7.6,-1.2 left textcolor rgb "#3A799C" front
set label 8 "rim of the big wheel" at 16,-4.2 left textcolor rgb "#606060" front
$big << EOD
x,y
-11,-5
26,-5
26,5
-11,5
EOD
$small << EOD
x,y
-9,-2.2
9,-2.2
9,2.2
-9,2.2
-9,-2.2
EOD
plot $big using 1:2 with filledcurves closed lc rgb light, \
     $small using (c*$1-s*$2):(s*$1+c*$2) with filledcurves closed lc rgb sky
