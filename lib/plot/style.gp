# The one look of all figures. A script begins
#
#   load "style.gp"       (found through GNUPLOT_LIB; ARG1, ARG2 ... are the same after it)
#   set output ARG2
#
# and reads CSV with a header line: ARG1, and ARG3 ... if there are more. Columns go by name or number:
# plot ARG1 using "x_in":"p_psi". Inline data ($points << EOD) needs a header line and commas, too.
# Anything gnuplot says on stderr, a warning or a `print`, fails the figure.

set terminal pngcairo size 1000,560 font "DejaVu Sans,14" enhanced background rgb "white"
set encoding utf8
set minussign
set datafile separator comma
set datafile columnheaders

# Palette of Okabe and Ito (2008), safe for colour-blind readers. Printed in grey, lines are told apart by
# dash and width, points by shape: `lt 1` ... `lt 8`, or by name, `lc rgb blue`.
black  = "#000000"
blue   = "#0072B2"
red    = "#D55E00"
green  = "#009E73"
purple = "#CC79A7"
orange = "#E69F00"
sky    = "#56B4E9"
grey   = "#808080"
light  = "#D9D9D9"

set linetype 1 lc rgb black  lw 2.6 dt solid          pt 7  ps 1.1
set linetype 2 lc rgb blue   lw 2.6 dt (14,5)         pt 5  ps 1.1
set linetype 3 lc rgb red    lw 2.6 dt (14,4,2,4)     pt 9  ps 1.3
set linetype 4 lc rgb green  lw 3.2 dt (3,3)          pt 13 ps 1.4
set linetype 5 lc rgb purple lw 2.2 dt (20,4,2,4,2,4) pt 11 ps 1.3
set linetype 6 lc rgb orange lw 4.0 dt solid          pt 4  ps 1.2
set linetype 7 lc rgb sky    lw 2.2 dt (6,6)          pt 8  ps 1.3
set linetype 8 lc rgb grey   lw 1.6 dt solid          pt 12 ps 1.4
set linetype cycle 8

# Styles with a meaning, used as `with points ls printed`:
printed   = 101 # a number printed in the paper
digitised = 102 # a point read off the paper's figure
guide     = 103 # a limit, an asymptote, an axis of symmetry
band      = 104 # `with filledcurves ls band`: what the reference itself does not know
other     = 105 # a number of another paper, or of an independent method
set style line printed   lc rgb red   pt 6 ps 1.7 lw 2.4
set style line digitised lc rgb blue  pt 2 ps 1.2 lw 2.0
set style line guide     lc rgb grey  lw 1.4 dt (8,6)
set style line band      lc rgb light
set style line other     lc rgb green pt 4 ps 1.5 lw 2.2

set border 3 lw 1.2 lc rgb "#404040"
set tics nomirror out scale 0.75
set grid xtics ytics back lc rgb "#CCCCCC" lw 1 dt solid
set key noautotitle opaque box lc rgb "#BBBBBB" width 1 height 0.4 samplen 3.5 spacing 1.1
set style fill solid 1.0 noborder
set tmargin 2.2
set rmargin 4
# A colour bar that stays readable in grey: viridis (see lib/scene), dark is low.
set palette defined (0 "#440154", 1 "#482878", 2 "#3E4A89", 3 "#31688E", 4 "#26828E", 5 "#1F9E89", \
                     6 "#35B779", 7 "#6DCD59", 8 "#B4DE2C", 9 "#FDE725")
