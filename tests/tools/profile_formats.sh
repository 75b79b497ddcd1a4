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
