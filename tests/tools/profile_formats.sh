#!/usr/bin/env bash
# profile_formats.sh RAILBOOK: one wheel and one rail in each form of file give the conicities of the tables they were made from.
set -euo pipefail
examples=$(cd "$(dirname "$0")/../../tools/examples/hunting" && pwd)
work=$(mktemp -d)
trap 'rm -r "$work"' EXIT
cd "$work"
rows() { # FILE PROGRAM: the points as $1 inward and $2 height
  awk -F, '!/^#/ && !/inward/ {'"$2"'}' "$examples/$1"
}
w=worn-wheel.csv r=new-rail.csv
{ printf 'ProgramName=x\nColumnDef=X,Y,A\n\n'; rows $w 'printf "%.3f %.3f 0\n", 70 - $1, -$2'; } > a.whl
{ printf 'ProgramName=x\nColumnDef=X,Y\n\n'; rows $r 'printf "%.3f %.3f\n", $1, $2'; } > a.ban
for f in "w $w" "r $r"; do
  { printf 'header.begin\nheader.end\nspline.begin\nunits.len.f = 1000\npoint.begin\n'; rows "${f#? }" 'printf "%.3f %.3f\n", -$1, -$2'
    printf 'point.end\nspline.end\n'; } > "a.pr${f%% *}"
done
rows $w 'printf "%.6f %.6f %% m\n", $1 / 1000, $2 / 1000' > wheel.txt
rows $r 'printf "%.3f\t%.3f\n", -$1, -$2' > rail.txt
{ printf 'WHEELPROFILE\nt\nTREADDATUM EUROPEAN\nFLANGEBACK 1360\n'
  rows $w 'printf "%.3f,%.3f,%.3f,%.3f\n", $1 - 750, -$2, 750 - $1, -$2'; } > a.whe
{ printf 'RAILPROFILE\nt\nGAUGEPOINT EUROPEAN\nGAUGE 1435\n'
  rows $r 'printf "%.3f,%.3f,%.3f,%.3f\n", $1 - 750, $2, 750 - $1, $2'; } > a.rai
answer() { "$1" hunting geometry --wheel "$2" --rail "$3" | grep 'equivalent conicity'; }
answer "$1" "$examples/$w" "$examples/$r" > wanted
[ "$(wc -l < wanted)" -gt 10 ]
for pair in "a.whl a.ban" "a.prw a.prr" "wheel.txt rail.txt" "a.whe a.rai"; do
  answer "$1" $pair > found
  diff wanted found || { echo "$pair: other conicities"; exit 1; }
done
"$1" wheelrail contact --wheel a.whl --rail a.prr --load 50kN --speed 10m/s --slip 0 --roll 0rad --method strips | grep -q 'read as MiniProf'

# A rail written from its other side.
rows worn-rail.csv 'printf "%.3f %.3f\n", $1, $2' > other.txt
answer "$1" a.whl "$examples/worn-rail.csv" > wanted
"$1" hunting geometry --wheel a.whl --rail other.txt --mirror-rail > all
! grep -q 'gauge side' all
grep 'equivalent conicity' all | diff wanted - || { echo "mirrored: other conicities"; exit 1; }

# What files have besides: each wheel on the new rail, and the worn wheel on each rail, has the conicities of the plain tables to 2 %, or the
# file is refused with its reason. `back` and `rim` are what a probe meets beside the tread, both folding back; `sides` a whole rail head.
railbook=$1
back='70 - 0.1 * k, -24 + k' rim='-50 + 0.05 * k, 0.4 + k'
mkdir forms
wheel() { # FORMAT: the points from rim to back
  awk -F, -v f="$1\n" 'BEGIN {for (k = 12; k > 0; --k) printf f, -50 + 0.05 * k, 0.4 + k} !/^#/ && !/inward/ && $1 < 69.5 {printf f, $1, $2} END {for (k = 1; k < 15; ++k) printf f, 69.8 - 0.1 * k, -26 + k}' "$examples/$w"
}
outward() { awk -v s="$1" -v d="$2" -v form="$3\n" '{printf form, (d - $1) * s, -$2 * s}'; } # a wheel's X from DATUM, flange upward, in 1/S mm
rail() { # the whole head, its field side as its gauge side, with its upright sides
  awk -F, 'BEGIN {n = 0} !/^#/ && !/inward/ {u[n] = $1; z[n++] = $2} END {
    for (k = 20; k > 0; --k) printf "%.4f %.4f\n", -38.79 + 0.02 * k * (k % 2), -24.5 - k
    for (i = n - 1; u[i] > -u[0] + 0.2; --i) print -u[i], z[i]
    for (i = 0; i < n; ++i) print u[i], z[i]
    for (k = 1; k < 20; ++k) printf "%.4f %.4f\n", 38.79 - 0.02 * k * (k % 2), -24.5 - k}' "$examples/$r"
}
all() { wheel '%.4f %.4f'; }
{ printf '#MINIWHEELPROF\nMINIPROF 2020\n32.58 37.11 14.71\n(Sd/Sh/qR)\n\n'; all | outward 1 70 '%9.4f %9.4f'; } > forms/old-header.whl
{ printf 'MINIPROF 1994\nx\n\n'; all | outward 1 70 '%.4f, %.4f'; } > forms/1994.whl
{ printf 'ProgramName=x\nStock=%%X\nColumnDef=X,Y,A,C,K\n\n'; all | outward 1 70 '%.4f,%.4f,1.5,-0.02,0'; } > forms/key-value.whl
{ printf 'ProgramName=x\nColumnDef=X,Y,A\n\n'; all | outward 1 0 '%.4f %.4f 0'; } > forms/from-tape-circle.whl
{ printf 'ProgramName=x\nColumnDef=X,Y\n\n'; all | outward 0.001 70 '%.7f %.7f'; } > forms/in-metres.whl
{ printf 'header.begin\nheader.end\nspline.begin\nunits.len.f = 1000\npoint.begin\n'; all | awk '{print -$1, -$2}'; printf 'point.end\nspline.end\n'; } > forms/millimetres.prw
{ printf 'header.begin\nheader.end\nspline.begin\nunits.len.f = 1\nmirror.y = 1\npoint.begin\n'; all | awk '{print $1 / 1000, -$2 / 1000}'; printf 'point.end\nspline.end\n'; } > forms/metres-mirrored.prw
{ printf '! Kpf\n'; all | awk '{printf "%10.5f %10.5f   # a remark\n", $1, -$2}'; } > forms/gensys.wheel
all | awk '{printf "%.7f %.7f\n", -$1 / 1000, $2 / 1000}' > forms/blanks-in-metres.txt
{ printf 'y;z\n'; all | awk '{printf "%.4f;%.4f\n", -$1, $2}' | tr . ,; } > forms/decimal-comma.txt
all | awk '{printf "%.6f %.6f\n", $1 / 25.4, $2 / 25.4; if (NR % 17 == 0) printf "%.6f %.6f\n", $1 / 25.4, $2 / 25.4}' > forms/inches-with-doubles.txt
all | awk '{printf "%d\t%.4f\t%.4f\n", NR, -$1, -$2}' > forms/counted-upside-down.dat
{ printf 'WHEELPROFILE\nt\nTREADDATUM EUROPEAN\nFLANGEBACK 1360\n'; all | awk '{printf "%.4f,%.4f,%.4f,%.4f\n", $1 - 750, -$2, 750 - $1, -$2}'; } > forms/vampire.whe
{ printf 'ProgramName=x\nRail=%%L\nColumnDef=X,Y,A,C,K\n\n'; rail | awk '{print $1 ", " $2 ", 0, 0, 0"}'; } > forms/key-value.ban
{ printf '#MINIRAILPROF\nMINIPROF 2020\n\n'; rail; } > forms/old-header.ban
{ printf '[FileInfo]\nDate=1\n[Profile1Info]\nMPD1=L\n[Profile1Points]\n'; rail; } > forms/one-section.mpt
{ cat forms/one-section.mpt; printf '[Profile2Info]\nMPD1=R\n[Profile2Points]\n'; rail | awk '{print $1, $2 - 1}'; } > forms/two-sections.mpt
{ printf 'ProgramName=x\nColumnDef=X,Y\n\n'; rail; awk 'BEGIN {for (u = 39; u < 80; ++u) print u, -44; for (u = 80; u < 110; ++u) print u, -(u - 95) ^ 2 / 60}'; } > forms/guard-rail.ban
{ printf 'header.begin\nheader.end\nspline.begin\nunits.len.f = 1000\npoint.begin\n'; rail | awk '{print -$1, -$2}'; printf 'point.end\nspline.end\n'; } > forms/millimetres.prr
rail | awk '{print -$1, $2}' > forms/outward.txt
rail | awk '{printf "%.7f %.7f // m\n", -$1 / 1000, -$2 / 1000}' > forms/metres-downward.txt
rail | awk '{print $1, -$2}' > forms/gensys.rail
rail | awk 'BEGIN {t = 1 / 40; c = cos(t); s = sin(t)} {print -($1 * c + $2 * s), $2 * c - $1 * s}' > forms/inclined-uic-519.dat
{ printf 'RAILPROFILE\nt\nGAUGEPOINT EUROPEAN\nGAUGE 1435\n'; rail | awk '{printf "%.4f,%.4f,%.4f,%.4f\n", $1 - 750, $2, 750 - $1, $2}'; } > forms/vampire.rai
conicity() { "$railbook" hunting geometry --end 8mm --step 0.1mm "$@" | sed -n 's/^ *equivalent conicity at [0-9]* mm, rolling axle *\([0-9.]*\).*/\1/p'; }
read_right() { # FILE OPTIONS...
  file=forms/$1
  shift
  case $file in
    *.whl | *.prw | *.wheel | *.whe | *blanks* | *comma* | *inches* | *counted*) pair=(--wheel "$file" --rail "$examples/$r") ;;
    *) pair=(--wheel "$examples/$w" --rail "$file") ;;
  esac
  conicity "${pair[@]}" "$@" > found || { echo "$file is not read"; exit 1; }
  paste usual found | awk '{d = $2 / $1 - 1; if (d > 0.02 || d < -0.02 || NF != 2) exit 1} END {exit NR != 8}' || { echo "$file: $(paste usual found | tr '\n' ';')"; exit 1; }
  count=$((count + 1))
}
conicity --wheel "$examples/$w" --rail "$examples/$r" > usual
count=0
for file in old-header.whl 1994.whl key-value.whl from-tape-circle.whl in-metres.whl millimetres.prw metres-mirrored.prw gensys.wheel blanks-in-metres.txt \
  decimal-comma.txt inches-with-doubles.txt counted-upside-down.dat vampire.whe key-value.ban old-header.ban one-section.mpt guard-rail.ban millimetres.prr \
  outward.txt metres-downward.txt vampire.rai; do read_right $file; done
read_right two-sections.mpt --rail-section 1
read_right gensys.rail --mirror-rail
read_right inclined-uic-519.dat --cant 0
echo "$count forms are read right"
refused() { # PATTERN FILE...: as a rail, or as a wheel where it is one
  pattern=$1
  shift
  status=0
  "$railbook" hunting geometry "$@" > said 2>&1 || status=$?
  [ "$status" -eq 2 ] && grep -q "$pattern" said || { echo "$*: status $status, $(cat said)"; exit 1; }
}
refused 'second section.*--rail-section' --wheel "$examples/$w" --rail forms/two-sections.mpt
printf 'rail.slcs\nU_OFFSET 0\nNSLC 2\n0 a.prr\n1 b.prr\n' > forms/track.slcs
refused 'list of slices along a rail' --wheel "$examples/$w" --rail forms/track.slcs
rail | awk '$1 < 10 {print -$1, $2}' > forms/half-a-head.txt
refused 'ends .* below its top on the gauge side' --wheel "$examples/$w" --rail forms/half-a-head.txt
awk 'BEGIN {for (u = -30; u <= 30; ++u) print u, 0.01 * u}' > forms/flat.txt
refused 'highest at\|upside down' --wheel "$examples/$w" --rail forms/flat.txt
printf '<?xml version="1.0"?>\n<RailProfile><p y="1" z="2"/></RailProfile>\n' > forms/profile.xml
refused 'XML' --wheel "$examples/$w" --rail forms/profile.xml
printf "\$---------MDI_HEADER\n[MDI_HEADER]\nFILE_TYPE = 'wheel'\n" > forms/adams.whl
refused 'property file of ADAMS' --wheel forms/adams.whl --rail "$examples/$r"
# What was dropped is said, with its place.
"$railbook" hunting geometry --wheel forms/old-header.whl --rail forms/key-value.ban > said
for what in 'wheel, left out.*header.*32.58' 'wheel, left out.*behind others' 'rail, left out.*\(behind others\|steeper\)'; do grep -q "$what" said || { echo "not said: $what in $(cat said)"; exit 1; }; done
