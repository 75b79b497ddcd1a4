#!/bin/sh
# exceptions.sh RAILBOOK: dips that a chord must find where they are, and no others; none at ends, gaps and in waves below the limit.
railbook=$1
folder=$(mktemp -d) || exit 1
trap 'rm -rf "$folder"' EXIT
cd "$folder" || exit 1
fail() { echo "$*"; cat said out/exceptions.csv; exit 1; }
# Track every foot, level at the left with dips of 40 mm at 1000 and 3000 ft, some 10 ft long, and one so near to a gap that no chord is whole; a wave at the right, a step into a gap.
awk 'BEGIN {print "distance_m,left_mm,line_mm"
  for (i = 0; i < 5000; ++i) {
    z = 5 * sin(i / 40) + -40 * (exp(-(i - 1000) ^ 2 / 18) + exp(-(i - 3000) ^ 2 / 18) + exp(-(i - 1985) ^ 2 / 18)) + 0.2 * sin(i * i)
    line = 16 * sin(2 * 3.14159265 * i / 62) + 0.2 * cos(i * i)
    printf "%.4f,%s,%.4f\n", i * 0.3048, (i >= 2000 && i < 2030 || i < 2000 && i > 1997 ? "" : sprintf("%.4f", z)), line}}' >track.csv
run() { "$railbook" quality measures track.csv --column left --alignment line --no-figures "$@" --out out >said 2>&1; }
run --fra-class 5 || fail "class 5"
# A dip that a 62-ft chord sees at its middle, and half of it, upward, 31 ft before and behind: 20 mm, below the limit of 31.75 mm.
[ "$(grep -c '^left,level chord 62ft,5,' out/exceptions.csv)" = 2 ] || fail "not two dips"
awk -F, '/^left/ && ($7 < 304.1 || $7 > 305.5) && ($7 < 913.7 || $7 > 915.1) {exit 1} /^left/ && ($8 != -31.75 || $6 > -35) {exit 1}' out/exceptions.csv || fail "not there"
# A 62-ft chord reads twice a wave of its own length: 32 mm of the 16, at each crest and trough, beyond class 5 (19.05 mm); 31 and 124 ft: once, and nothing.
n=$(grep -c '^line,alignment chord 62ft,' out/exceptions.csv)
[ "$n" -ge 158 ] && [ "$n" -le 162 ] || fail "$n crests"
run --fra-class 2 || fail "class 2"
[ "$(wc -l <out/exceptions.csv)" = 1 ] || fail "exceptions to class 2"
run --fra-class 6 --chords 31ft 124ft || fail "class 6"
grep -q '^line,alignment uniformity 31ft,6,' out/exceptions.csv && grep -q '^line,alignment uniformity 62ft,6,' out/exceptions.csv || fail "class 6"
grep -q '^left\|^line,alignment uniformity 124ft,' out/exceptions.csv && fail "what class 6 does not say"
awk -F, 'NR == 1 {for (i = 1; i <= NF; ++i) c[$i] = i} NR == 3 {exit !($c["line_chord_31ft_largest_mm"] ^ 2 > 15 ^ 2 && $c["line_chord_31ft_largest_mm"] ^ 2 < 17 ^ 2 && $c["line_chord_124ft_largest_mm"] ^ 2 < 1)}' out/measures.csv || fail "chords"
"$railbook" quality measures track.csv --column left --fra-class 7 >said 2>&1
[ $? = 2 ] && grep -q "limits are of alignment only.*--alignment" said || fail "class 7 without alinement"
