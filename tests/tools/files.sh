#!/bin/sh
# files.sh RAILBOOK: one record in the spellings of many recorders; each must give the answer of the plain one.
railbook=$1
folder=$(mktemp -d) || exit 1
trap 'rm -rf "$folder"' EXIT
cd "$folder" || exit 1
fail() { echo "$*"; exit 1; }
"$railbook" psd synthesize plain.csv --length 12km --spacing 25cm --roughness 5e-7m^2*cycle/m --corner 0.13cycle/m --dip 11mm >/dev/null || fail "synthesize"
value() { sed -n 's/^  roughness A *\([0-9.e-]*\) .*/\1/p' said; }
"$railbook" psd classify plain.csv >said || fail "$(cat said)"
A=$(value)
cases=0
# same WHAT arguments...: the roughness to 2 %, class 5, 12 km.
same() {
  what=$1
  shift
  cases=$((cases + 1))
  "$railbook" psd classify "$@" >said 2>&1 || fail "$what: $(cat said)"
  awk -v a="$A" -v b="$(value)" 'BEGIN {exit !(b > 0 && (a - b < 0.02 * a) && (b - a < 0.02 * a))}' || fail "$what: $A, here $(cat said)"
  grep -q "^  length *1[12]\(\.[09][0-9]*\)\? km" said || fail "$what: $(cat said)"
}
body() { tail -n +2 plain.csv; }
{ echo 'Weg (m);Höhe (mm)'; body | tr ,. ';,'; } >c.csv
same "semicolons and decimal commas" c.csv --distance Weg --column Höhe
{ printf 'Distance [m]\tProfile [mm]\n'; body | tr , '\t'; } >t.csv
same "tabs and brackets" t.csv
{ echo 'DISTANCE (KM),PROFILE (Inches)'; body | awk -F, '{printf "%.6f,%.8g\n", $1 / 1000, $2 / 25.4}'; } >k.csv
same "kilometres and inches" k.csv --column profile
{ echo 'Km,profile'; body | awk -F, '{printf "%.6f,%s\n", 12 + $1 / 1000, $2}'; } >u.csv
same "a column called Km, heights without a unit" u.csv --unit mm
{ echo 'chainage,profile_mm'; body | awk -F, '{printf "%d+%06.2f,%s\n", int($1 / 1000), $1 % 1000, $2}'; } >p.csv
same "km+m in a cell" p.csv --distance-unit m
{ echo '"pos";z'; body | awk -F, '{printf "%03dK%06.2fM;%s\n", int($1 / 1000), $1 % 1000, $2}'; } >j.csv
same "123K456.0M" j.csv --distance pos --distance-unit m --column z --unit mm
{ echo 'km_km,metre_m,profile_mm'; body | awk -F, '{printf "%d,%.2f,%s\n", int($1 / 1000), $1 % 1000, $2}'; } >two.csv
same "kilometres and metres in two columns" two.csv --distance km+metre
{ echo 'MP,MPFoot,PROF'; body | awk -F, '{f = $1 / 0.3048; printf "%d,%.4f,%.8g\n", int(f / 5280), f % 5280, $2 / 25.4}'; } >us.csv
same "miles and feet in two columns" us.csv --distance MP+MPFoot --distance-unit mi+ft --column prof --unit in
{ head -1 plain.csv; body | tac; } >d.csv
same "descending" d.csv
{ echo profile_mm; body | cut -d, -f2; } >s.csv
same "no distance" s.csv --spacing 25cm
{ head -1 plain.csv; body | awk -F, '{printf "%.1f,%s\n", $1, $2}'; } >r.csv
same "positions rounded to .1 m" r.csv
{ head -1 plain.csv; body | awk -F, '{printf "%d,%s\n", $1, $2}'; } >w.csv
same "positions in whole metres" w.csv
{ head -1 plain.csv; body | awk -F, 'NR % 500 == 7 {$2 = -9999} {print $1 "," $2}'; } >m.csv
same "a code for lost samples, named" m.csv --missing -9999
same "and found" m.csv
grep -q WARNING said || fail "a code that nobody named is not told"
{ head -1 plain.csv; body | awk -F, 'NR % 500 == 7 {$2 = "NV"} NR % 700 == 3 {$2 = "lost"} {print $1 "," $2}'; } >n.csv
same "words for lost samples" n.csv --missing lost
{ echo 'Recorder 7'; echo 'line 2, track 1'; cat plain.csv; } >h.csv
same "lines before the headers" h.csv --skip 2
body >bare.csv
same "no headers" bare.csv --distance 1 --distance-unit m --column 2 --unit mm
same "a column by its number" plain.csv --column 2
same "a column as #2" plain.csv --column '#2'
gzip -c plain.csv >plain.csv.gz
same "gzip" plain.csv.gz
{ head -1000 plain.csv | gzip -c; tail -n +1001 plain.csv | gzip -c; } >parts.gz
same "gzip in parts" parts.gz
{ printf '\357\273\277'; sed 's/$/\r/' plain.csv; } >crlf.csv
same "carriage returns and a byte-order mark" crlf.csv
"$railbook" psd classify - <plain.csv >said || fail "standard input: $(cat said)"
[ "$(value)" = "$A" ] || fail "standard input"
gzip -c plain.csv | "$railbook" psd classify - >said || fail "gzip on standard input: $(cat said)"
[ "$(value)" = "$A" ] || fail "gzip on standard input"
# One sample in a hundred lost costs a few per cent of the data, not all of it.
"$railbook" psd synthesize gaps.csv --length 50km --spacing 25cm --roughness 5e-7m^2*cycle/m --corner 0.13cycle/m --gaps 1% >/dev/null
"$railbook" psd classify gaps.csv --json >said || fail "gaps"
used=$(sed -n 's/.*"segments": "\([0-9]*\) samples in none.*/\1/p' said)
[ -n "$used" ] && [ "$used" -lt 40000 ] || fail "gaps of 1 % leave $used of 200000 samples unused"
echo "$cases spellings"
