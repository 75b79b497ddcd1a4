#!/bin/sh
# limits.sh RAILBOOK LIMITS: limits of a file are judged by channel, measure, value, class and speed; what cannot be judged is named. LIMITS: the FRA's, as shipped.
railbook=$1 shipped=$2
folder=$(mktemp -d) || exit 1
trap 'rm -rf "$folder"' EXIT
cd "$folder" || exit 1
fail() { echo "$*"; cat said out/exceptions.csv; exit 1; }
measures() { "$railbook" quality measures "$@" --no-figures --out out >said 2>&1; }
value() { sed -n "s/^ *\"$1\": \"\{0,1\}\([^\"]*[^\",]\)\"\{0,1\},\{0,1\}\$/\1/p" out/measures.json | head -1; }
# rows LIMIT: how many exceptions; one LIMIT CONDITION: there is one, of which the condition holds.
rows() { awk -F, -v limit="$1" '$2 == limit {++n} END {print n + 0}' out/exceptions.csv; }
one() { awk -F, -v limit="$1" "function near(a, b, off) {return a - b <= off && b - a <= off} \$2 == limit {++n; if (!($2)) exit 2} END {exit n != 1}" out/exceptions.csv || fail "$1: not one, or not $2"; }
refuses() {
  words=$1
  shift
  measures "$@"
  [ $? = 2 ] && grep -q -e "$words" said || fail "not refused with $words: $*"
}

# Level: waves of 10 m, of 4 mm in the third section and of 1 mm elsewhere, and a dip of 20 mm at 1500 m. Alignment: a curve with a versine of 30 mm on 10 m, and a
# kink of 16 mm at 700 m. Gauge: 9 mm wide from 800 to 1200 m, a step of 5 mm within 1 m at 300 m. Cross level: a ramp of 30 mm in 3 m at 1000 m, back at 1700 m.
awk 'BEGIN {print "distance_m,level_mm,line_mm,gauge_mm,wide_mm,cant_mm"; for (i = 0; i < 8000; ++i) {x = i / 4
  z = (x >= 400 && x < 600 ? 4 : 1) * sin(x * 0.62831853) - 20 * exp(-(x - 1500) ^ 2 / 2); y = 2.4 * (x - 1000) ^ 2 / 2 + 16 * exp(-(x - 700) ^ 2 / 2)
  g = (x >= 800 && x < 1200 ? 9 : 0) + (x >= 300 && x < 301 ? 5 : 0); c = x < 1000 ? 0 : x < 1003 ? 10 * (x - 1000) : x < 1700 ? 30 : x < 1730 ? 1730 - x : 0
  printf "%.2f,%.4f,%.4f,%.3f,%.3f,%.3f\n", x, z, y, 1435.1 + g, g, c}}' >track.csv
columns="--column level --alignment line --gauge gauge --crosslevel cant"
cat >limits.csv <<'END'
# Ours.
channel,measure,value,class,speed_from,speed_to,low,high,why
level,D1,sd,AL,,,,2mm,waves
level,D1,peak,AL,0km/h,120km/h,-9mm,9mm,slow
level,D1,peak,AL,120km/h,160km/h,-8mm,8mm,fast
level,D1,peak,IAL,120km/h,160km/h,-40mm,40mm,fast
level,chord 3m+7m,peak,AL,,,-15mm,15mm,
alignment,chord 10m,mean-to-peak 50m,AL,,,-12mm,12mm,
gauge,,mean 100m,AL,,,,8mm,
gauge,,peak,AL,,,1430mm,1438mm,a whole one
gauge,,mean-to-peak 100m,AL,,,-4.6mm,4.6mm,
crosslevel,twist 3m,peak,AL,,,-7mm/m,7mm/m,
crosslevel,change 3m,peak,IAL,,,-27mm,27mm,less than 3 m apart: eleven samples
END
# shellcheck disable=SC2086 # words
measures track.csv $columns --limits limits.csv --speed 160km/h || fail "all limits"
one "level D1 sd" '$4 == 400 && $5 == 600 && near($6, 2.8284, 0.03) && $7 == "nan" && $8 == 2 && $9 == "mm" && $3 == "AL"'
one "level D1" '$3 == "AL" && near($7, 1500, 0.01) && $6 < -9 && $8 == -8'
# 20 (1 - (7 exp(-4.5) + 3 exp(-24.5))/10) and what the waves add: 1 (1 - cos) of theirs, at most 2.
one "level chord 3m+7m" 'near($7, 1500, 0.3) && near($6, -20 * (1 - 0.7 * exp(-4.5)), 2)'
one "alignment chord 10m mean-to-peak 50m" 'near($7, 700, 0.01) && near($6, 16 * (1 - 2.5066 / 50 + 2.5066 / 50), 0.2)'
one "gauge mean 100m" 'near($4, 800 + 100 * 8 / 9 - 50, 0.6) && near($5, 1200 - 100 * 8 / 9 + 50, 0.6) && near($6, 1444.1, 1e-6) && near($8, 1443.1, 1e-9)'
[ "$(rows gauge)" = 2 ] && [ "$(awk -F, '$2 == "gauge" && $4 == 800 && $5 == 1199.75 && $8 == 1438 {print 1}' out/exceptions.csv)" = 1 ] || fail "whole gauge"
awk -F, '$2 == "gauge mean-to-peak 100m" {++n; if ($4 < 250 || $5 > 1251) exit 2} $2 == "gauge mean-to-peak 100m" && $4 == 300 {step = $6} END {exit !(n == 1 && step > 4.9 && step < 5)}' out/exceptions.csv || fail "gauge less its mean"
one "crosslevel twist 3m" '$4 > 1002 && $5 <= 1004 && near($6, 10, 1e-6) && $9 == "mm/m"'
one "crosslevel change 3m" '$3 == "IAL" && near($6, 27.5, 1e-6)'
[ "$(value exceptions)" = "$(($(wc -l <out/exceptions.csv) - 1)).0" ] && [ "$(value exceptions_level_D1_AL)" = 1.0 ] && [ "$(value not_judged)" = "" ] || fail "the summary: $(cat out/measures.json)"
grep -q 'not evaluated  *0 m .*up to 50 m at each end' said || fail "the ends: half of the mean of 100 m"
grep -q '^    level D1 AL .*(level -[0-9.]* mm at 1500 m, limit -8)' said || fail "the worst place"
# Another speed, a class, gauge as a deviation; the faster end of a range belongs to it.
# shellcheck disable=SC2086
for speed in 120km/h 50mph; do
  measures track.csv $columns --limits limits.csv --speed $speed --class AL || fail "$speed"
  one "level D1" '$8 == -9'
  grep -q IAL out/exceptions.csv && fail "another class"
done
cp out/exceptions.csv whole.csv
measures track.csv --column level --alignment line --gauge wide --crosslevel cant --limits limits.csv --speed 80km/h --class AL || fail "a deviation"
[ "$(grep -c '^wide' out/exceptions.csv)" = "$(grep -c '^gauge' whole.csv)" ] && grep -q '^wide,gauge mean 100m,AL,.*,9,.*,8,mm' out/exceptions.csv || fail "gauge as a deviation"
measures track.csv --column level --limits limits.csv --speed 80km/h || fail "one column"
grep -q 'not judged .*alignment chord 10m mean-to-peak 50m, gauge mean 100m, gauge,' said || fail "what is not judged"
# A nominal gauge of another network.
awk -F, -v OFS=, 'NR > 1 {$4 += 84.9} 1' track.csv >broad.csv
measures broad.csv --column level --gauge gauge --limits limits.csv --speed 80km/h && grep -q 'WARNING: column gauge is neither' said || fail "1520 mm"
measures broad.csv --column level --gauge gauge --limits limits.csv --speed 80km/h --nominal-gauge 1520mm && one "gauge mean 100m" 'near($8, 1528, 1e-6)'
# Where something is lost, nothing is said to be within its limits.
awk -F, -v OFS=, 'NR > 4000 && NR < 4009 {$2 = ""} 1' track.csv >lost.csv
measures lost.csv --column level --limits limits.csv --class IAL --speed 160km/h || fail "lost samples"
[ "$(value exceptions)" = null ] && [ "$(value not_evaluated_m)" = 52.0 ] || fail "8 samples, and 25 m on either side of them"
"$railbook" quality measures track.csv lost.csv --column level --limits limits.csv --class IAL --speed 160km/h --out many >said 2>&1 || fail "two records"
awk -F, 'NR == 1 {for (i = 1; i <= NF; ++i) c[$i] = i; next} $c["kind"] == "record" {printf "<%s>", $c["exceptions"]}' many/measures-table.csv >said
[ "$(cat said)" = "<0><>" ] || fail "two records"
# What is filtered or an offset already is judged as it is, to its ends, and by nothing else.
awk 'BEGIN {print "distance_m,left D1 [mm],long D2 [mm],versine [mm]"; for (i = 0; i < 4000; ++i) printf "%.2f,%.3f,%.3f,%.3f\n", i / 4, i == 2 ? 11 : sin(i / 7), 3 * sin(i / 30), i == 3 ? 16 : 0.1 * sin(i)}' >ready.csv
measures ready.csv --column "left D1,long D2" --filtered by-name --limits limits.csv --class AL --speed 80km/h || fail "by name"
grep -q 'WARNING.*filtered' said && fail "a warning of what is said"
one "level D1" '$1 == "left D1" && $4 == 0.5 && $6 == 11'
grep -q 'not judged .*level D1 sd of long D2, .*level chord 3m+7m of left D1' said || fail "what a filtered column cannot show"
head -1 out/measures.csv | grep -q 'left D1_D1_sd_mm,.*long D2_D2_sd_mm' && ! head -1 out/measures.csv | grep -q 'chord\|D1_D2' || fail "columns of filtered ones"
awk -F, 'NR == 1 {for (i = 1; i <= NF; ++i) c[$i] = i; next} $c["fra_class"] != "nan" || $c["left D1_D1_sd_mm"] != $c["left D1_sd_mm"] {exit 1}' out/measures.csv || fail "a class of a band"
measures ready.csv --column "left D1" --filtered D2 && grep -q "WARNING.*D1 by its name, and to D2" said || fail "two names"
measures ready.csv --column versine --chord 3m+7m --limits limits.csv --class AL --speed 80km/h || fail "offsets"
one "level chord 3m+7m" '$4 == 0.75 && $6 == 16'
measures ready.csv --column versine --chord 7m+3m --limits limits.csv --class AL --speed 80km/h && [ "$(value exceptions)" = null ] || fail "offsets of the other end"
# Free bands, divided chords and means of versines beside the sections: waves of 10 m of 4 mm.
measures track.csv --column level --alignment line --bands 6m-15m,D2 --chords 10m 3m+7m --chord-mean 50m || fail "bands and chords"
awk -F, 'function near(a, b, off) {return a - b <= off && b - a <= off} NR == 1 {for (i = 1; i <= NF; ++i) c[$i] = i; next}
  $1 == 400 {exit !(near($c["level_6m-15m_sd_mm"], 2.828, 0.03) && near($c["level_chord_3m+7m_largest_mm"] ^ 2, (8 * sin(0.3 * 3.14159265)) ^ 2, 0.5) && near($c["level_chord_10m_largest_mm"] ^ 2, 64, 0.8))}
  $1 == 1000 {exit !near($c["line_chord_10m_largest_mm"], 0, 0.01)}' out/measures.csv || fail "bands and chords: $(cat out/measures.csv)"

# The FRA's classes are a file like others.
awk -F, -v OFS=, 'NR > 1 {$3 = $2 * 1.3; $2 *= 3; $6 *= 2} 1' track.csv >rough.csv
# shellcheck disable=SC2086
for class in 1 2 3 4 5 6 7 8 9; do
  measures rough.csv $columns --fra-class $class && cp out/exceptions.csv fra.csv && n=$(value exceptions) || fail "class $class"
  measures rough.csv $columns --limits "$shipped" --class $class && cmp -s fra.csv out/exceptions.csv && [ "$(value exceptions)" = "$n" ] || fail "class $class as a file"
done
# shellcheck disable=SC2086
measures rough.csv $columns --limits "$shipped" --class 4,5 && [ "$(cut -d, -f3 out/exceptions.csv | sort -u | xargs)" = "4 5 class" ] || fail "two classes"

# Refused, with the line.
bad() {
  words=$1
  printf 'channel,measure,value,class,speed_from,speed_to,low,high\n%s\n' "$2" >bad.csv
  refuses "$words" track.csv --column level --limits bad.csv
}
bad "line 2: channel is .top.*level, alignment" "top,D1,peak,,,,,8mm"
bad "line 2: measure (chord, uniformity, twist or change LENGTH, or a band): .D7.; allowed: D0" "level,D7,peak,,,,,8mm"
bad "line 2: value is .mean.;\|line 2: length of the mean" "level,D1,mean,,,,,8mm"
bad "line 2: value is .rms.*sd, mean LENGTH" "level,D1,rms,,,,,8mm"
bad "line 2: high .*without a unit" "level,D1,peak,,,,,8"
bad "line 2: high.*unit" "crosslevel,twist 3m,peak,,,,,8mm"
bad "line 2: neither low nor high" "level,D1,peak,,,,,"
bad "line 2: low is 0.008 and high -0.008" "level,D1,peak,,,,8mm,-8mm"
bad "line 2: twist of level" "level,twist 3m,peak,,,,,8mm/m"
bad "line 2: speed_from" "level,D1,peak,,80km/h,80km/h,,8mm"
bad "depend on the speed.*--speed" "level,D1,peak,,,80km/h,,8mm"
bad "limits are of gauge only" "gauge,,peak,,,,,8mm"
bad "has no limits" ""
bad "shortest wavelength of the band is 0.3 m" "level,0.3m-3m,peak,,,,,8mm"
refuses 'no limits of class "4"; allowed: AL, IAL' track.csv --column level --limits limits.csv --speed 80km/h --class 4
refuses "no column .channel\|no column channel" track.csv --column level --limits track.csv
refuses "one of --fra-class and --limits" track.csv --column level --limits limits.csv --fra-class 3
refuses "with --limits FILE" track.csv --column level --speed 80km/h
refuses "one of them" track.csv --column level --chord 10m --filtered D1
refuses "filtered.*D0, D1, D2, D3" track.csv --column level --filtered D8
refuses "chords" track.csv --column level --chords 3m+
refuses "none.csv" track.csv --column level --limits none.csv
exit 0
