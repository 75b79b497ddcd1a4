# Sourced by tables.sh.
# A bump in the middle and one at the end, where it is not sure; a gap, and a code for lost samples over the border of two segments.
awk 'BEGIN {print "distance_m,profile_mm"; for (i = 0; i < 12000; ++i) {x = i / 4
  z = 0.3 * sin(i * i) + 60 * exp(-((x - 1010) / 8) ^ 2) + 60 * exp(-((x - 2985) / 8) ^ 2)
  printf "%.2f,%s\n", x, (i >= 2000 && i < 2050 ? "" : i >= 7590 && i < 7610 ? "-999.9" : sprintf("%.4f", z))}}' >bumps.csv
answers index index bumps.csv --speed 100km/h --segment 100m
holds "segments" index/segments.csv '
  {samples += $3; missing += $4; faulty += $5; if ($9 > most) most = $9; here += $c["exceedances"]; near($2 - $1, 100, 1e-6); class = $c["class"]}
  $5 > 0 {places = places $1 ","} class == "repair" {repair = repair $1 ","} class == "unsure" {unsure = unsure $1 ","}
  class == "accept" && $9 > 0.5 || class == "watch" && !($9 > 0.5 && $9 <= 1) {wrong++}
  END {near(samples, 12000, 0); near(faulty, 20, 0); near(missing, m, 0); near(most, l, 1e-5); near(here, e, 0); near(rows, 30, 0)
    if (places "|" repair "|" unsure != "1800,1900,|1000,|2900,") {print "faulty, repair, unsure: " places " " repair " " unsure; wrong++}}' \
  m="$(v index missing)" l="$(v index largest)" e="$(v index exceedances)"
holds "exceedances" index/exceedances.csv '
  abs($1 - 1010) < 1 {near($2, l, 0.5); if ($c["unsure"] != "no") wrong++} $1 > 2900 && $c["unsure"] != "yes" {wrong++} END {near(rows, e, 0)}' \
  l="$(v index largest)" e="$(v index exceedances)"
holds "the channel" index/channel.csv '$2 != "" && $2 != "nan" && abs($2) > most {most = abs($2)} $2 == "" || $2 == "nan" {++none}
  END {near(most, l, 1e-5); near(rows, 12000, 0); near(none, m, 0)}' l="$(v index largest)" m="$(v index missing)"
# The same track measured again, half a sample on, 3 m out and counting 1 in 2000 too much: no growth, and no offset but those.
for first in 0 0.125; do
  awk -v first=$first 'BEGIN {print "distance_m,profile_mm"; for (i = 0; i < 12000; ++i) {x = i / 4 + first; w = 2 * 3.14159265358979 * x
    printf "%.3f,%.5f\n", x + (first > 0 ? 3 + x / 2000 : 0), 4 * sin(w / 10 + 3 * sin(x / 97)) + 3 * sin(w / 23 + 2 * sin(x / 61))}}' >run$first.csv
done
answers growth compare run0.csv run0.125.csv --section 200m
holds "growth" growth/compare.csv '$3 != "nan" && $4 != "nan" && $4 != "" {near($4 / $3, 0.998, 0.003); near($6, 3 + ($1 + $2) / 4000, 0.05); if (!($7 > 0.99)) wrong++; ++n}
  END {if (n < 13) {print n " sections"; wrong++}}'
near "first offset" "$(v growth offset_from_m)" 3.05 0.05
near "last offset" "$(v growth offset_to_m)" 4.45 0.05
# The worst places in order of their size, whatever their sign.
"$railbook" psd synthesize track.csv --length 6km --seed 3 --roughness 2e-6m^2*cycle/m >/dev/null || fail "synthesize"
answers worst index track.csv --speed 100km/h
sed -n 's/^  "worst_[0-9]": "\([+-][0-9.]*\) at.*/\1/p' worst.json >order
awk '{size = $1 < 0 ? -$1 : $1; if (NR > 1 && size > last) exit 1; last = size; down += $1 < 0} END {exit NR != 5 || down < 1}' order ||
  fail "the worst: $(cat order)"
# A ramp of 0.05 mm/m in cross level is that twist; the class is that of the largest offset of a 62-ft chord (49 CFR 213.63, mm).
awk -F, 'NR == 1 {print $0 ",cross_mm"; next} {printf "%s,%.4f\n", $0, $1 / 20}' bumps.csv >cross.csv
answers measures measures cross.csv --crosslevel cross
holds "measures" measures/measures.csv '
  $c["missing"] == 0 {near($c["twist_largest_mm_per_m"], 0.05, 1e-4); near($c["twist_sd_mm_per_m"], 0, 1e-4); near($c["cross_sd_mm"], 0.05 * 200 / sqrt(12), 0.01)}
  {d = abs($c["profile_chord_largest_mm"]); class = (d <= 76.2) + (d <= 69.85) + (d <= 57.15) + (d <= 50.8) + (d <= 31.75)
    if ($c["profile_chord_largest_mm"] != "") {near($c["fra_class"], class, 0); if (class < 5) ++rough}}
  END {if (rough < 1 || rough > 3) {print rough " rough sections"; wrong++}}'
[ ! -e measures/exceptions.csv ] || fail "exceptions to a class that nobody gave"
# Where one limit alone counts there is no wavelength from which the other does.
"$railbook" quality limit --speed 100km/h --json >stroke.json && ! grep -q corner_m stroke.json || fail "a corner of one limit"
# Between two places of extremes.csv the channel reaches its high and low, or zero, and not beyond.
awk -F, 'function settle() {if (row > 1 && (abs(high - h[row]) > 1e-5 || abs(low - l[row]) > 1e-5)) {print at[row], h[row], high, l[row], low; wrong++} high = low = 0}
  function abs(x) {return x < 0 ? -x : x}
  FNR == 1 {next} NR == FNR {at[++n] = $1; l[n] = $2; h[n] = $3; next}
  {while (row < n && $1 / 1000 >= at[row + 1] - 1e-9) {settle(); ++row}} $2 == "" || $2 == "nan" {next} $2 > high {high = $2} $2 < low {low = $2}
  END {settle(); exit wrong > 0 || n < 100}' worst/extremes.csv worst/channel.csv >said || fail "extremes: $(head -3 said)"
holds "the histogram" index/histogram.csv '{sum += $2} END {near(sum, 12000 - m, 0)}' m="$(v index missing)"
# The limits of a car by hand: a roll mode on a wavy track, r^2 / sqrt((1 - r^2)^2 + (2 z r)^2) of the amplitude, whose peak holds for all
# shorter waves, since slower trains meet it there; and the force of two masses, w^2 |m_w + m_b (k + i b w) / (k - m_b w^2 + i b w)|.
functions='function root(x) {return x ^ 0.5} function min(x, y) {return x < y ? x : y} function max(x, y) {return x > y ? x : y}
  function gain(r) {return r ^ 2 / root((1 - r ^ 2) ^ 2 + (2 * z * r) ^ 2)}
  function by_stroke(wave, r) {r = V / wave / f; return stroke / (r > 1 / root(1 - 2 * z ^ 2) ? 1 / (2 * z * root(1 - z ^ 2)) : gain(r))}
  function by_force(wave, w, re, im, d) {w = 2 * 3.14159265358979 * V / wave; re = k - mb * w ^ 2; im = b * w; d = re ^ 2 + im ^ 2
    return (F - 9.80665 * (mw + mb)) / (w ^ 2 * root((mw + mb * (k * re + im ^ 2) / d) ^ 2 + (mb * (im * re - k * im) / d) ^ 2))} '
car="V=30 f=0.6 z=0.15 stroke=0.04 mw=900 mb=9000 F=150e3 k=$(awk 'BEGIN {printf "%.12g", 9000 * (3 * 3.14159265358979) ^ 2}') b=$(awk 'BEGIN {printf "%.12g", 1.2 * 9000 * 3 * 3.14159265358979}')"
level=$(awk 'BEGIN {printf "%.12g", 0.04 * 2 * 0.15 * sqrt(1 - 0.15 ^ 2)}')
stiff=$(echo "$car" | sed 's/.* k=\([0-9.]*\) b=\(.*\)/--stiffness \1N\/m --damping \2N*s\/m/')
for how in "--stroke 4cm --bounce-frequency 1.5Hz --bounce-damping 0.6" "--level ${level}m $stiff"; do
  # shellcheck disable=SC2086 # options
  answers limit limit --speed 30m/s --roll-frequency 0.6Hz --roll-damping 0.15 $how --wheel-mass 900kg --body-mass 9t --wheel-force 150kN --wavelength 0.8m 3m 40m 300m
  # shellcheck disable=SC2086 # assignments
  means limit 'is("speed_km_per_h", 108); is("stroke_limit_cm", 100 * stroke); says("stroke_limit_cm", "0.6 Hz, damping 0.15"); is("level_cm", 100 * stroke * 2 * z * root(1 - z ^ 2))
    is("flat_until_m", V / f * root(1 - 2 * z ^ 2), 1e-5); is("static_force_kN", 9.9 * 9.80665); is("force_margin_kN", F / 1e3 - 9.9 * 9.80665)
    is("corner_m", v["corner_m"]); ours = by_force(v["corner_m"]) / by_stroke(v["corner_m"]); if (abs(ours - 1) > 1e-5) bad("corner " ours)
    n = split("0.8 3 40 300", waves, " "); for (; n > 0; --n) {w = waves[n]; key = "amplitude_cm_at_" w "_m"; is(key, 100 * min(by_stroke(w), by_force(w)))
      says(key, by_force(w) < by_stroke(w) ? "wheel force" : "stroke")}' $car
done
# shellcheck disable=SC2086 # assignments
holds "the allowed amplitude" limit/limit.csv '{near($2 / min($3, $4), 1, 1e-5); near($3 / (100 * by_stroke($1)), 1, 1e-4); near($4 / (100 * by_force($1)), 1, 1e-4)}
  rows == 1 {near($1, 0.5, 0)} {last = $1} END {near(last, 1000, 0); near(rows, 266, 0)}' $car
functions=
# A lightly damped body has a resonance of the force; a mode that counts alone says nothing of the other, nor of a corner.
answers resonant limit --speed 30m/s --wheel-mass 900kg --body-mass 9t --bounce-frequency 1.5Hz --bounce-damping 0.1 --wavelength 20m --mode force
grep -q '"force_note"' resonant.json && ! grep -q 'force_note' limit.json || fail "a resonance of the wheel force"
[ "$(head -1 resonant/limit.csv)" = "wavelength_m,amplitude_cm,force_cm" ] || fail "columns of the force alone"
means resonant 'for (key in v) if (key ~ /stroke|level|flat|corner/) bad(key); else free(key); says("amplitude_cm_at_20_m", "wheel force")'
answers both limit --speed 30m/s --wheel-mass 900kg --body-mass 9t --bounce-frequency 1.5Hz --bounce-damping 0.1 --wavelength 20m --mode combined
answers alone limit --speed 30m/s --wheel-mass 900kg --body-mass 9t --bounce-frequency 1.5Hz --bounce-damping 0.1 --wavelength 20m --mode stroke
means alone 'is("stroke_limit_cm", v["stroke_limit_cm"]); for (key in v) if (key ~ /force|corner/) bad(key); else free(key); says("amplitude_cm_at_20_m", "stroke")'
near "the smaller amplitude" "$(v both amplitude_cm_at_20_m)" "$(awk -v a="$(v resonant amplitude_cm_at_20_m)" -v b="$(v alone amplitude_cm_at_20_m)" 'BEGIN {print a < b ? a : b}')" 1e-4
grep -q corner_m both.json || fail "no corner of two limits"
