# Sourced by tables.sh.
# A run forth, back and forth: speeds have no sign, rows are in order of the road.
"$railbook" filters simulate --out drive.csv --length 4000ft --speeds 40mph 0mph -20mph 0mph 40mph --distances 1500ft 1ft 800ft 1ft 300ft --stand 60s >/dev/null || fail "simulate"
answers geometry process drive.csv
near "fastest" "$(v geometry fastest_mph)" 40 0.01
awk -v slow="$(v geometry slowest_mph)" 'BEGIN {exit !(slow > 0 && slow < 5)}' || fail "slowest: $(v geometry slowest_mph)"
near "gage" "$(v geometry gage_mean)" 1435 2
# A road counted from elsewhere is the same road.
awk -F, -v OFS=, 'NR == 1 {for (i = 1; i <= NF; ++i) if ($i ~ /^distance/) d = i} NR > 1 {$d += 0.1} 1' drive.csv >moved.csv
answers moved process moved.csv
for key in rows rejected runs gage_mean crosslevel_mean; do near "$key elsewhere" "$(v moved $key)" "$(v geometry $key)" 1e-6; done
holds "gage in the table" geometry/geometry.csv '$c["gage_is"] == "good" {sum += $c["gage_mm"]; squares += $c["gage_mm"] ^ 2; ++n}
  END {mean = sum / n; near(mean, m, 1e-3); near(sqrt(squares / n - mean ^ 2), d, 0.01); near(100 * n / rows, g, 0.1)}' \
  m="$(v geometry gage_mean)" d="$(v geometry gage_deviation)" g="$(v geometry gage_good_percent)"
# An ideal car over a true track: what it measures is the track, parameter by parameter, and the answer is the table's mean and deviation where it is good.
"$railbook" filters simulate --out ideal.csv --truth truth.csv --length 3000ft --speeds 50mph --curvature 0.02deg/ft --superelevation 80mm --grade 0.002 --seed 3 --json >ideal.json || fail "simulate"
draws ideal2 process ideal.csv
awk -F, 'NR == FNR {if (FNR == 1) {for (i = 1; i <= NF; ++i) t[i] = $i; n = NF} else for (i = 2; i <= n; ++i) truth[$1, t[i]] = $i; next}
  FNR == 1 {for (i = 1; i <= NF; ++i) c[$i] = i; for (i = 2; i <= n; ++i) {is[t[i]] = 0; for (k = 1; k <= NF; ++k) if ($k ~ /_is$/ && index(t[i], substr($k, 1, length($k) - 2)) == 1) is[t[i]] = k} next}
  {for (i = 2; i <= n; ++i) {name = t[i]; if (!is[name] || $is[name] !~ /good|degraded/ || truth[$1, name] == "" || truth[$1, name] == "nan") continue; d = $c[name] - truth[$1, name]; off[name] += d * d; u = truth[$1, name]; sum[name] += u; size[name] += u * u; ++rows[name]}}
  END {for (i = 2; i <= n; ++i) {name = t[i]; if (rows[name] == 0) {++none; continue} rms = sqrt(off[name] / rows[name]); of = sqrt(size[name] / rows[name]); ++compared; if (!(rms < 0.25 * of)) {print name, rms, of; bad = 1}}
    if (compared != 13) {print compared " compared, " none " never good"; bad = 1} exit bad}' truth.csv ideal2/geometry.csv >said || fail "an ideal car: $(cat said)"
awk -F, 'NR == 1 {for (i = 1; i <= NF; ++i) {if ($i ~ /_is$/) {q[++n] = i; name[n] = substr($i, 1, length($i) - 3)}} for (k = 1; k <= n; ++k) c[k] = k + 2; next}
  {if ($2 != "nan") {v = $2 < 0 ? -$2 : $2; if (slow == "" || v < slow) slow = v; if (v > fast) fast = v} ++rows; for (k = 1; k <= n; ++k) {++is[k, $q[k]]; if ($q[k] == "good") {sum[k] += $c[k]; squares[k] += $c[k] ^ 2}}}
  END {print "rows", rows; print "slowest_mph", slow; print "fastest_mph", fast; print "runs", 1; print "rejected", 0
    for (k = 1; k <= 9; ++k) {g = is[k, "good"]; print name[k] "_good_percent", 100 * g / rows; note = sprintf("good %.1f %%, degraded %.1f, unreliable %.1f, missing %.1f", 100 * g / rows, 100 * is[k, "degraded"] / rows, 100 * is[k, "unreliable"] / rows, 100 * is[k, "missing"] / rows)
      if (g > 0) {m = sum[k] / g; print name[k] "_mean", m; print name[k] "_deviation", sqrt(squares[k] / g - m ^ 2); print name[k] "_mean", note >"notes"} else print name[k] "_note", note >"notes"}}' ideal2/geometry.csv >found
while read -r key value; do near "$key of an ideal car" "$(v ideal2 "$key")" "$value" "$(awk -v x="$value" 'BEGIN {print 1e-3 * (x < 0 ? -x : x) + 1e-4}')"; done <found
while read -r key note; do grep -q "\"$key\": \"$note\"" ideal2.json || fail "$key does not say $note"; done <notes
grep -q '"warnings": {}' ideal2.json || fail "warnings about an ideal car"
cmp -s ideal2.drawn/1/d1.csv ideal2/geometry.csv || fail "what is drawn of a short record"
# The car begins 20 ft ahead of its truck spacing; at a steady speed each foot takes as long as the last, and the track's end is not passed.
holds "a steady drive" ideal.csv 'rows == 1 {first = $1} rows > 1 {near($2, 0.3048 / (50 * 0.44704), 1e-9); near($1 - last, 0.3048, 1e-6)} {last = $1} END {near(last > 914.4 - 0.62 && last < 914.4, 1, 0); near(rows, 1 + (last - first) / 0.3048, 1e-3)
  near(first > 44.5 * 0.3048 - 6.096 && first < 90 * 0.3048, 1, 0)}'
# Constant rates that the gyros say too much are taken out by name.
awk -F, -v OFS=, 'NR == 1 {for (i = 1; i <= NF; ++i) {if ($i ~ /^yaw_rate/) y = i; if ($i ~ /^roll_rate/) r = i}} NR > 1 {$y += 0.5; $r -= 0.25} 1' ideal.csv >biased.csv
answers unbiased process biased.csv --yaw-bias 0.5deg/s --roll-bias -0.25deg/s
for key in curvature_mean curvature_deviation crosslevel_mean crosslevel_deviation; do near "$key without bias" "$(v unbiased $key)" "$(v ideal2 $key)" 1e-3; done
# Distances may be off the marks by a quarter of a foot, values out of range in one row of a hundred.
for off in 0.07:0 0.08:2; do
  awk -F, -v OFS=, -v off=${off%:*} 'NR == 1000 {$1 += off} 1' ideal.csv >off.csv
  "$railbook" filters process off.csv >said 2>&1
  [ $? = ${off#*:} ] || fail "a mark that is off by ${off%:*} m: $(tail -2 said)"
done
for share in 0.008 0.012; do
  awk -F, -v OFS=, -v every="$(awk -v s=$share 'BEGIN {print int(1 / s)}')" 'NR > 1 && NR % every == 0 {$3 = 21} 1' ideal.csv >beyond.csv
  "$railbook" filters process beyond.csv --json >said 2>&1
  n=$(awk -F, 'NR > 1 && $3 == 21 {++n} END {print n}' beyond.csv)
  grep -q "\"beyond\": \"$n values beyond" said || fail "$n values beyond the range: $(grep beyond said)"
  if [ $share = 0.012 ]; then grep -q '"vertical_left-range"' said || fail "more than 1 % beyond"; else grep -q '"vertical_left-range"' said && fail "less than 1 % beyond"; fi
done
awk -F, -v OFS=, 'NR == 1500 {$9 += 54} NR == 1600 {$9 -= 54} NR == 1700 {$9 += 40} NR >= 1800 && NR < 1802 {$9 += 54} 1' ideal.csv >spikes.csv
"$railbook" filters process spikes.csv --json >said 2>&1
grep -q '"spikes": "2 spikes of' said || fail "spikes of 54 mm up and down, one of 40 mm and one of two rows: $(grep spike said)"
# Without a column of distances each row is a foot further, but for a pulse too many.
cut -d, -f2- ideal.csv | awk -F, -v OFS=, '{print} NR == 1200 {$1 = 0; print}' >pulses.csv
answers pulses process pulses.csv
for key in gage_mean gage_deviation crosslevel_mean; do near "$key with a pulse too many" "$(v pulses $key)" "$(v ideal2 $key)" 0.01; done
near "rows with a pulse too many" "$(v pulses rows)" 2921 0
near "the pulse" "$(v pulses rejected)" 1 0
near "the one run" "$(v pulses runs)" 1 0
# Backwards the car begins at the end; where it stands, a row takes that long.
"$railbook" filters simulate --out back.csv --length 1000ft --speeds -60mph --seed 3 >/dev/null || fail "backwards"
holds "backwards" back.csv 'rows == 1 {near($1, 304.5, 0.31)} rows > 1 {near($1 - last, -0.3048, 1e-6); near($2, 0.3048 / 26.8224, 1e-9)} {last = $1}'
"$railbook" filters simulate --out stands.csv --length 2000ft --speeds 30mph 0mph 30mph --distances 300ft 1ft 300ft --stand 25s --rate 1m/s^2 >/dev/null || fail "a stand"
holds "a stand" stands.csv '$2 > longest {longest = $2; at = rows} {time += $2; last = $1} rows == 1 {first = $1} END {near(longest, 25.7, 0.9); v = 30 * 0.44704; near(time, 25 + 2 * 91.44 / v + 2 * v, 0.1); near(last - first, 2 * 91.44 + v ^ 2, 0.62)}'
# A long record is drawn by every second of its rows, and is as long; a value of either sign that no sensor gives is masked.
"$railbook" filters simulate --out long.csv --length 24000ft --speeds 60mph >/dev/null || fail "simulate"
awk -F, -v OFS=, 'NR == 500 {$4 = -1e6} NR == 600 {$4 = 1e6} 1' long.csv >wild.csv
draws wild process wild.csv
grep -q '"2 values beyond what a sensor can give' wild.json || fail "values beyond what a sensor gives"
for table in wild.drawn/*/*.csv; do
  awk -F, 'NR == 2 {first = $1} NR > 2 && ($1 - last - 0.6096) ^ 2 > 1e-9 {bad = 1} {last = $1}
    END {exit !(NR > 10000 && NR < 20000 && !bad && last - first > 7000)}' "$table" || fail "$table: $(wc -l <"$table") rows"
done
