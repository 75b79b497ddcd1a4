#!/bin/sh
# records.sh RAILBOOK: nothing is taken out of a record unasked, every column is looked at, positions and headers are read as written.
railbook=$1
folder=$(mktemp -d) || exit 1
trap 'rm -rf "$folder"' EXIT
cd "$folder" || exit 1
fail() { echo "$*"; cat said; exit 1; }
measures() { "$railbook" quality measures "$@" --no-figures >said 2>&1; }
# value KEY: of the answer in JSON.
value() { sed -n "s/^ *\"$1\": \"\{0,1\}\([^\",]*\)\"\{0,1\},\{0,1\}\$/\1/p" "${2:-out/measures.json}" | head -1; }
near() { awk -v a="$2" -v b="$3" -v t="$4" 'BEGIN {exit !(a != "" && a - b <= t && b - a <= t)}' || fail "$1: $2 is not $3"; }
track='function track(x) {return 0.6 * sin(x / 1.16) + 0.5 * sin(x / 2.18) + 0.8 * sin(x / 4.93)}'

# Dips of rails and welds in good track stay where they are, and are told as rows.
for dip in "V 60 4" "V 40 2" "V 60 2" "cosine 60 3" "V 20 1" "V 12 0.75"; do
  # shellcheck disable=SC2086 # three words
  set -- $dip
  awk -v shape="$1" -v depth="$2" -v half="$3" "$track"' BEGIN {print "distance_m,profile_mm"; for (i = 0; i < 4800; ++i) {x = i / 4; d = x < 600 ? 600 - x : x - 600
    z = d > half ? 0 : shape == "V" ? 1 - d / half : 0.5 * (1 + cos(3.14159265 * d / half)); printf "%.2f,%.3f\n", x, track(x) - depth * z}}' >dip.csv
  measures dip.csv --fra-class 4 --out out || fail "$dip"
  [ "$(value faulty)" = 0.0 ] && [ "$(value missing)" = 0.0 ] || fail "$dip: taken out"
  [ "$1" = cosine ] || grep -q '^profile,\(jumps\|outliers\|steps\),[56]9.*,no,' out/warnings.csv || fail "$dip is no row: $(cat out/warnings.csv)"
  [ "$2" = 60 ] && { awk -F, '/^profile/ && $7 > 599 && $7 < 601 && $6 < -54 {++n} END {exit n != 1}' out/exceptions.csv || fail "$dip is no exception"; }
  measures dip.csv --screen steps --out out || fail "$dip"
  [ "$(value faulty)" = 0.0 ] || fail "$dip: comes back, and is no step of the datum"
done
# A code is taken out, and no class is stated there; `--screen none` keeps it.
awk "$track"' BEGIN {print "distance_m,profile_mm"; for (i = 0; i < 4800; ++i) printf "%.2f,%s\n", i / 4, i == 1700 ? "-999.9" : sprintf("%.3f", track(i / 4))}' >code.csv
measures code.csv --fra-class 4 --out out || fail "a code"
[ "$(value faulty)" = 1.0 ] && [ "$(value exceptions)" = null ] || fail "no exceptions, though a sample was taken out"
awk -F, 'NR == 1 {for (i = 1; i <= NF; ++i) c[$i] = i; next} ($c["fra_class"] == "nan") != ($1 == 400) {exit 1}' out/measures.csv || fail "a class: $(cat out/measures.csv)"
measures code.csv --fra-class 4 --screen none --out out && [ "$(value faulty)" = 0.0 ] || fail "--screen none"

# The warnings and losses of each column, and gauge, cross level and warp against their limits.
awk "$track"' BEGIN {print "distance_m,left_mm,right_mm,gauge_mm,cant_mm"; for (i = 0; i < 8000; ++i) {x = i / 4; d = x < 1500 ? 1500 - x : x - 1500; dip = d < 0.75 ? 12 * (1 - d / 0.75) : 0
  printf "%.2f,%.3f,%s,%.3f,%.3f\n", x, track(x), i == 500 ? "" : sprintf("%.3f", track(x + 3) - dip), 1435 + 0.5 * sin(x / 3) + (x > 700 && x < 702 ? 40 : 0), (x > 1100 && x < 1105 ? 70 : 0) + 0.7 * sin(x / 5)}}' >all.csv
measures all.csv --column left,right --gauge gauge --crosslevel cant --fra-class 3 --out out || fail "all columns"
for key in right_outliers gauge_; do grep -q "\"$key" out/measures.json || fail "no warning of $key"; done
grep -q 'right,outliers,1499' out/warnings.csv || fail "no row of the right rail"
grep -q '^gauge,gauge,3,700.25,.*,1466.85,mm$' out/exceptions.csv || fail "gauge"
grep -q '^cant,crosslevel,3,1100.25,' out/exceptions.csv && grep -q '^cant,crosslevel change 62ft,3,1100.25,' out/exceptions.csv || fail "cross level and warp"
[ "$(value bridged)" = 1.0 ] && grep -q '"judged": "gauge, level chord 62ft, crosslevel, crosslevel change 62ft"' out/measures.json || fail "what is judged"
awk -F, 'NR == 1 {for (i = 1; i <= NF; ++i) c[$i] = i; next} $1 == 600 && $c["fra_class"] != 0 || $1 == 1000 && $c["fra_class"] != 1 || $1 == 200 && $c["fra_class"] != 5 {exit 1}' out/measures.csv || fail "classes"
"$railbook" quality compare all.csv all.csv --column left,right --no-figures --out both >said 2>&1 || fail "compare"
[ "$(grep -c ',left,' both/compare.csv)" = 10 ] && [ "$(grep -c ',right,' both/compare.csv)" = 10 ] || fail "both rails"
# A wave fits again after its length; tamped track is named.
awk 'BEGIN {for (run = 1; run < 3; ++run) {file = run ".csv"; print "distance_m,profile_mm" >file; for (i = 0; i < 8000; ++i) printf "%.2f,%.4f\n", i / 4, 3 * sin((i / 4 - (run == 2 ? 3.6 : 0)) * 6.2832 / 12.7) >file}}'
"$railbook" quality compare 1.csv 2.csv --json >said && grep -q '"ambiguous": ".*12.[67][0-9]* m further' said && near "offset" "$(value offset_from_m said)" 3.6 0.05 || fail "a wave"

# Positions: one row a sample of 0.25 m, waves of 10 m of 3 mm. reads WHAT arguments...: their deviation in D1.
wave='function wave(x) {return sprintf("%.4f", 3 * sin(x * 0.62831853))}'
reads() {
  what=$1
  shift
  measures "$@" --out out || fail "$what"
  near "$what" "$(value "$(sed -n 's/^ *"\(.*_D1_median_sd\)".*/\1/p' out/measures.json | head -1)")" 2.1213 0.01
  near "$what, spacing" "$(value spacing_m)" 0.25 1e-6
}
# refuses WORDS arguments...
refuses() {
  words=$1
  shift
  measures "$@" && fail "not refused: $*"
  grep -q -e "$words" said || fail "does not say $words"
}
awk "$wave"' BEGIN {print "distance_m,rail,level_mm"; for (i = 0; i < 4000; ++i) printf "%.2f,L,%s\n%.2f,R,%s\n", i / 4, wave(i / 4), i / 4, 3 * wave(i / 4)}' >long.csv
refuses "--where COLUMN=VALUE" long.csv --column level
refuses "there are: L, R" long.csv --column level --where rail=left
reads "one rail of two" long.csv --column level --where rail=L
near "the other" "$(measures long.csv --column level --where rail=R --out out; value level_D1_median_sd)" 6.364 0.02
awk -F, 'NR == 1 {print; next} $2 == "L" {print; left = left} $2 == "R" {right[++n] = $0} END {for (i = 1; i <= n; ++i) print right[i]}' long.csv >blocks.csv
refuses "sample 4001.*--resync cut" blocks.csv --column level
measures blocks.csv --column level --resync cut --out out && grep -q 'level,cuts,1000,1000,1,-999750' out/warnings.csv || fail "two runs in one file: $(cat out/warnings.csv)"
awk "$wave"' BEGIN {print "distance_m,profile_mm"; for (i = 0; i < 4000; ++i) printf "%.2f,%s\n", 100 + i / 4 - (i > 2000 ? 0.5 : 0), wave(i / 4)}' >back.csv
refuses "sample 2002.*--resync cut" back.csv
reads "an odometer set back" back.csv --resync count
grep -q '"counted"' out/measures.json || fail "counted on without a word"
reads "the same, cut" back.csv --resync cut
awk "$wave"' BEGIN {print "place_km+m,profile_mm"; for (i = 0; i < 8000; ++i) {x = i / 4; k = x < 996 ? 0 : 1; printf "%d+%06.2f,%s\n", 10 + k, x - 996 * k, wave(x)}}' >post.csv
measures post.csv --distance place --out out && grep -q '"kilometre"' out/measures.json || fail "a short kilometre is not told"
reads "a kilometre of 996 m" post.csv --distance place --resync count
[ "$(value missing)" = 0.0 ] || fail "a kilometre of 996 m has no gap"
awk "$wave"' BEGIN {print "Location_mi,profile_mm"; for (i = 0; i < 6000; ++i) {x = 0.25 * i / 0.3048; printf "%d+%09.4f,%s\n", 87 + int(x / 5280), x % 5280, wave(i / 4)}}' >miles.csv
refuses "mi+ft or mi+yd" miles.csv --distance Location
reads "miles and feet" miles.csv --distance Location --distance-unit mi+ft
# Headers: a chord is no unit, "in mm" no product, a row may hold the units; rows of nothing end a sheet.
for header in profile_62_ft "Versine 10 m" align_31_ft; do
  awk -v header="$header" "$wave"' BEGIN {print "distance_m," header; for (i = 0; i < 4000; ++i) printf "%.2f,%s\n", i / 4, wave(i / 4)}' >header.csv
  refuses "names no unit; give one with --unit" header.csv --column 2
  reads "$header" header.csv --column 2 --unit mm
done
for header in level_left_in_mm versine_10_m_mm "Top 35 m [mm]" rail_1_mm; do
  awk -v header="$header" "$wave"' BEGIN {print "distance_m," header; for (i = 0; i < 4000; ++i) printf "%.2f,%s\n", i / 4, wave(i / 4)}' >header.csv
  reads "$header" header.csv --column 2
done
awk "$wave"' BEGIN {print "Distance,Profile"; print "m,mm"; for (i = 0; i < 4000; ++i) printf "%.2f,%s\n", i / 4, wave(i / 4)}' >units.csv
reads "a row of units" units.csv
printf '11\n12\n15\n13\n14\n12\n' >bare.csv
measures bare.csv --column 1 --unit um --spacing 1m --bands D1 || grep -q "shortest\|samples" said || fail "a first row of numbers is no row of units"
awk "$wave"' BEGIN {print "distance_m,profile_mm,note"; for (i = 0; i < 4000; ++i) printf "%s,%s,\n", i == 777 ? "" : sprintf("%.2f", i / 4), wave(i / 4); print ",,"; print ",,"}' >tail.csv
reads "empty rows" tail.csv
[ "$(value bridged)" = 1.0 ] && grep -q '"unplaced"' out/measures.json || fail "a lost position is not told"
sed '50s/,[^,]*,/,inv,/' tail.csv >inv.csv
refuses 'line 50.*--missing "inv"' inv.csv
sed '1i Recorder 7' tail.csv >preamble.csv
refuses "--skip" preamble.csv --distance distance
awk 'BEGIN {print "distance_m,profile_mm"; for (i = 0; i < 50; ++i) print i ",\"1,2" i % 10 "0.5\""}' >thousands.csv
refuses "without a mark of thousands" thousands.csv
awk 'BEGIN {print "distance_km,profile_mm"; for (i = 0; i < 500; ++i) print i / 4 "," i % 7}' >metres.csv
refuses "at least 500 m, the samples being 250 m apart" metres.csv

# Miles and yards: 12.0440 is 12 miles and 440 yards.
awk 'BEGIN {print "Pos [mi.yd],profile_mm"; for (i = 1700; i < 6000; ++i) printf "%d.%04d,%.4f\n", 12 + int(i / 1760), i % 1760, 3 * sin(i * 0.9144 * 0.62831853)}' >yards.csv
measures yards.csv --distance Pos --out out || fail "miles and yards"
near "miles and yards, spacing" "$(value spacing_m)" 0.9144 1e-6
awk -F, -v first="$(awk 'BEGIN {print 12 * 1609.344 + 1700 * 0.9144}')" 'NR == 2 {exit !($1 <= first && $1 + 200 > first)}' out/measures.csv || fail "where miles and yards begin"
printf 'Pos,profile_mm\n1.0000,1\n1.1761,2\n1.1762,1\n' >beyond.csv
refuses "1760" beyond.csv --distance Pos --distance-unit mi.yd

# Columns that are filtered, or offsets of a chord, by their names; waves beyond 25 m that are not there.
awk "$track"' BEGIN {print "distance_m,Left level D1 [mm],left_mco_62_ft (mm),plain_mm,short_mm"; for (i = 0; i < 8000; ++i) {x = i / 4
  short = sin(x / 2.6) + sin(x / 1.7) + sin(x / 0.9) + 0.15 * sin(x / 5.5); printf "%.2f,%.4f,%.4f,%.4f,%.4f\n", x, track(x), (x > 800 && x < 801 ? 40 : 0) + track(x), track(x), short}}' >named.csv
measures named.csv --column "Left level D1" --out out && grep -q 'WARNING: .*filtered to D1 already, by its name' said || fail "a column named D1"
measures named.csv --column short --out out && grep -q 'WARNING: .*hardly any waves longer than 25 m' said || fail "a column filtered to D1"
measures named.csv --column plain --out out && ! grep -q WARNING said || fail "a column of any name"
measures named.csv --column 3 --fra-class 4 --out out && grep -q 'WARNING: .*offset of a chord, by its name' said || fail "a column of offsets"
[ "$(value exceptions)" = null ] && awk -F, 'NR == 1 {for (i = 1; i <= NF; ++i) c[$i] = i; next} $c["fra_class"] != "nan" {exit 1}' out/measures.csv || fail "a class of the offsets of offsets"
measures named.csv --column 3 --chord 62ft --fra-class 4 --out out && ! grep -q 'by its name' said || fail "the chord of a column of offsets"
awk -F, 'NR == 2 {exit !($2 == "level chord 62ft" && $7 > 38 && $7 < 42 && $4 > 800 && $4 < 801 && $5 <= 801)} NR > 2 {exit 1}' out/exceptions.csv || fail "offsets against their limit: $(cat out/exceptions.csv)"
measures named.csv --column 3 --chord 31ft --fra-class 4 --out out && [ "$(value exceptions)" = null ] || fail "a chord that has no limit"

# The same for the descriptor, and the names that recorders of other networks give.
index() { "$railbook" quality index "$@" --speed 100km/h --no-figures >said 2>&1; }
index named.csv --column "Left level D1" && grep -q 'WARNING: .*filtered to D1, by its name' said || fail "the descriptor of a column named D1"
index named.csv --column short && grep -q 'WARNING: .*hardly any waves longer than 25 m' said || fail "the descriptor of a column filtered to D1"
index named.csv --column plain && ! grep -q WARNING said || fail "the descriptor of a column of any name"
for name in "L PROF 62 (in)" "PROF_L_62 (in)" "Left 62' Profile (in)" "LPROF62 (in)" "Mid-Ord L (in)" "left mid ordinate (in)"; do
  sed "1s/.*/distance_m,$name/; 2,\$s/,.*,\(.*\),.*/,\1/" named.csv >chords.csv
  index chords.csv --column 2 && grep -q 'WARNING: .*offset of a chord, by its name' said || fail "the descriptor of $name"
  measures chords.csv --column 2 --fra-class 4 --out out && grep -q 'WARNING: .*offset of a chord, by its name' said || fail "the class of $name"
done
sed '1s/.*/distance_m,Top Left 35m (mm)/; 2,$s/,.*,\(.*\),.*/,\1/' named.csv >britain.csv
measures britain.csv --column 2 --fra-class 4 --out out && grep -q 'WARNING: .*only waves shorter than 35 m, by its name' said || fail "a high-passed column"
index britain.csv --column 2 && grep -q 'WARNING: .*only waves shorter than 35 m' said || fail "the descriptor of a high-passed column"

# Track without joints.
"$railbook" psd synthesize smooth.csv --length 6km --spacing 25cm --roughness 2e-7m^2*cycle/m --corner 0.13cycle/m --dip 0mm --seed 3 >said 2>&1 || fail "synthesize"
"$railbook" psd classify smooth.csv --no-rail --json >said 2>&1 || fail "--no-rail"
[ "$(value rail_m said)" = null ] && near "A of jointless track" "$(value A said)" 2e-7 3e-8 || fail "--no-rail"
"$railbook" psd classify smooth.csv --rail 500m >said 2>&1; grep -q -e "--no-rail" said || fail "the refusal does not name --no-rail"

# Clean records, of any roughness: at most one in twenty has a warning.
warned=0
for seed in $(seq 1 40); do
  "$railbook" psd synthesize clean.csv --length 1500m --spacing 25cm --seed "$seed" --roughness "$((seed * seed))e-9m^2*cycle/m" --corner 0.1cycle/m --noise "0.0$((seed % 7))mm" --dip "$((seed % 3 * 2))mm" >said 2>&1 || fail "synthesize"
  measures clean.csv --fra-class 5 --out out || fail "seed $seed"
  grep -q WARNING said && warned=$((warned + 1))
done
[ $warned -le 2 ] || fail "$warned of 40 clean records have a warning"
exit 0

# Containers: a damaged file, a pipe, and the command alone, without the program that reads them.
printf '\211HDF\r\n\032\n damaged' >damaged.h5
refuses 'damaged.h5": .*HDF5 file' damaged.h5
refuses 'no HDF5 or MAT file; allowed: no --dataset' all.csv --column left --dataset run/1
mkdir alone
cp "$railbook" alone/railbook
alone/railbook psd classify damaged.h5 >said 2>&1
[ $? -eq 2 ] && grep -q 'built without libhdf5; write the numbers as CSV, for example by h5dump' said || fail "the command alone"
