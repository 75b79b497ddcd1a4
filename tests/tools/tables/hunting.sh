# Sourced by tables.sh.
# The table goes over the range; where the greatest growth passes zero is the critical speed, with its frequency.
answers speed speed --lowest 20m/s --highest 80m/s
holds "growth over speed" speed/speed.csv '
  rows == 1 {near($1, 20, 1e-6)} rows > 1 {near($1 - last, 0.25, 1e-5)} $2 < $4 {wrong++}
  rows > 1 && $2 > 0 && before <= 0 {near(last - before * ($1 - last) / ($2 - before), hopf, 0.01); ++roots; near($3, omega, 0.1)}
  {last = $1; before = $2} END {near(last, 80, 1e-6); near(roots, 1, 0)}' \
  hopf="$(v speed hopf_1_m_per_s)" omega="$(v speed hopf_1_rad_per_s)"
# Centred, both sides are alike; displaced, each wheel touches its rail where it has moved to, and the right radius grows no more than the left.
answers pair geometry --pair cn
holds "contacts" pair/contacts.csv '
  rows == 1 {near($2, $4, 1e-6); near($3, $5, 1e-6); near($2, $3, 1e-6)}
  $1 < 5 {near($2 + $1, $3, 0.2); near($4 - $1, $5, 0.2)} !($3 > 700 && $5 > 700) {wrong++}'
holds "rolling radii" pair/wheelset.csv '{near($4, $2 - $3, 1e-5); near($c["D_rad"], ($5 - $6) / 2, 1e-5)}'
# The branch begins at the critical speed and has the extent that is told; what limits the creep is below it for small motions.
answers cycle cycle --pair cn --largest-amplitude 3mm --wheel-rail-friction 0.3 --speed 38.5m/s
extent=$(sed -n 's/^  "branch_extent": "\([0-9.]*\) to \([0-9.]*\) m.s, \([0-9.]*\) to \([0-9.]*\) mm",\?$/a=\1 b=\2 c1=\3 d=\4/p' cycle.json)
# shellcheck disable=SC2086
holds "a branch of cycles" cycle/cycle.csv '
  rows == 1 {slow = fast = $2; small = large = $3; near($2, hopf, 1); near($3, 1, 0.05)}
  $2 < slow {slow = $2} $2 > fast {fast = $2} $3 < small {small = $3} $3 > large {large = $3}
  {near($c["L_over_V"] > 0 && $c["creep_over_friction"] > 0 && $c["creep_over_friction"] < 1, 1, 0)
   near(($c["stable_mm"] == "nan") + ($c["unstable_mm"] == "nan"), 1, 0); near($c["front_leading_mm"], $3, 1e-6)}
  END {near(slow, a, 5.1e-3); near(fast, b, 5.1e-3); near(small, c1, 5.1e-4); near(large, d, 5.1e-4); near(rows, n, 0)}' \
  $extent hopf="$(v cycle hopf_m_per_s)" n="$(v cycle branch_points)"
# The answer is what the tables begin with; conicities are those of Klingel's wave, 2 pi sqrt(a r / c), and a wheelset that is not steered back has none.
means pair 'a = 29.76 * 0.0254; is("contact_mm", contact, 1e-6); is("delta_rad", delta, 1e-6); is("radius_mm", 16.5 * 25.4, 1e-6); says("pair", "^cn, of the paper"); is("slope_R", a * R / dx, 1e-5); is("slope_D", a * D / dx, 1e-5); is("slope_Phi", a * phi / dx, 1e-5)
  is("jumps", jumps); is("jump_1_mm", first, 1e-6); says("jumps", "more than 0.1 mm"); for (k = 1; k <= 19; ++k) {free("conicity_at_" k "_mm"); split(notes["conicity_at_" k "_mm"], word, /[ ,]+/)
    wave = 2 * pi * (a * 16.5 * 0.0254 / v["conicity_at_" k "_mm"]) ^ 0.5; if (abs(word[8] - wave) > 0.006) bad("wave of " k " mm: " notes["conicity_at_" k "_mm"])}' \
  $(awk -F, 'NR == 2 {print "contact=" $3}' pair/contacts.csv) $(awk -F, 'NR == 2 {print "delta=" $5} NR == 3 {print "dx=" $1 / 1e3 " phi=" $7 " R=" $8 " D=" $9}' pair/wheelset.csv | xargs) \
  jumps=$(($(wc -l <pair/jumps.csv) - 1)) first="$(awk -F, 'NR == 2 {print $1}' pair/jumps.csv)"
holds "conicities" pair/conicity.csv '{near($1, 0.1 * rows, 1e-6); near($5 / (2 * 3.14159265358979 * (29.76 * 0.0254 * 16.5 * 0.0254 / $2) ^ 0.5), 1, 1e-4); if (rows < 40) {near($3 / $2, 1, 2e-3); near($4 / $2, 1, 2e-3)}} END {near(rows, 190, 0)}'
holds "a table of the wheelset" pair/wheelset.csv '{near($1, 0.0635 * (rows - 1), 1e-5); near($8, ($2 - $3) / 2 / (29.76 * 25.4), 2e-6 + 1e-3 * abs($8))} END {near(rows, 301, 0)}'
for k in 1 2 3 10 19; do near "conicity at $k mm" "$(v pair conicity_at_${k}_mm)" "$(awk -F, -v k=$k 'NR > 1 && $1 - k < 1e-6 && k - $1 < 1e-6 {print $2}' pair/conicity.csv)" 1e-5; done
holds "jumps" pair/jumps.csv '{near($2 < $3 && $4 < $5, 1, 0); near($1 > 5 && $1 < 19.05, 1, 0)}'
# A table that ends before a step of 1 mm has the conicity at its end; kept from rolling, the axle stands.
answers little geometry --pair cn --end 0.5mm --step 0.05mm
near "the conicity at the end" "$(v little conicity_at_0.5_mm)" "$(awk -F, 'END {print $2}' little/conicity.csv)" 1e-6
answers level geometry --pair cn --level --end 4mm --step 0.05mm
holds "a level axle" level/wheelset.csv '{near($7, 0, 0)}'
near "its slope" "$(v level slope_Phi)" 0 0
# A paper's pair has its place, and no side of its own.
for option in "--gauge 57in" "--gauge-depth 14mm" "--cant 0.05" "--back-to-back 1.36001m" "--datum 71mm" "--radius 420mm" "--half-spacing 750mm" "--noise 0.01mm"; do
  # shellcheck disable=SC2086 # an option
  "$railbook" hunting geometry $option 2>&1 | grep -q "pairs have their own place" || fail "$option with a pair of the paper"
done
for option in "--right-wheel w.csv" "--right-rail r.csv" "--right-radius 420mm"; do
  # shellcheck disable=SC2086 # an option
  "$railbook" hunting speed $option 2>&1 | grep -q "which are the left ones" || fail "$option without the left one"
done
# The modes at a speed are those of the table there, and its critical speeds are told in every unit; datums that are not the paper's are named, with their units.
answers modes speed --lowest 20m/s --highest 80m/s --speed 40m/s --body-mass 40t --half-wheelbase 0.8m --vertical-damper 20kN*s/m
row=$(awk -F, '$1 == 40 {print $2, $3, $4, $5}' modes/speed.csv)
means modes 'split(row, at, "_"); is("body-mass", 40000); says("body-mass", "not the paper"); is("half-wheelbase", 0.8); says("half-wheelbase", "not the paper"); is("mode_1_growth", at[1], 1e-5); says("mode_1_growth", sprintf("^[^|]*. %#.4g rad/s; wheelsets [01]", at[2])); oscillating = 0
  for (k = 1; ("mode_" k "_growth") in v; ++k) {key = "mode_" k "_growth"; free(key); if (k > 1 && v[key] > v["mode_" k - 1 "_growth"]) bad("order of " key); if (notes[key] ~ /rad.s; wheelsets/ && ++oscillating == 2) is(key, at[3], 1e-5)}
  if (k < 10 || oscillating < 2) bad(k - 1 " modes"); is("critical_speeds", count = v["critical_speeds"]); says("critical_speeds", "from 20 to 80 m/s"); is("slope_R", 0.052, 0.01); is("slope_D", 0, 1e-9); is("slope_Phi", 0.052, 0.01); says("pair", "^new"); says("suspension", "dampers")
  for (k = 1; k <= count; ++k) {h = "hopf_" k "_"; V = v[h "m_per_s"]; free(h "m_per_s " h "rad_per_s " h "wheelsets " h "body"); says(h "m_per_s", sprintf("%#.4g ft.s, %#.4g km.h; grows (above|below)", V / 0.3048, V * 3.6)); says(h "rad_per_s", sprintf("%#.4g Hz", v[h "rad_per_s"] / (2 * pi)))
    n = split(v[h "wheelsets"], w, ", "); most = 0; for (; n > 0; --n) if (w[n] > most) most = w[n]; if (most != 1) bad("wheelsets " v[h "wheelsets"])}
  says("hopf_1_m_per_s", "grows above")' row="$(echo "$row" | tr ' ' _)"
for range in "20m/s 25m/s:stable throughout:-" "60m/s 70m/s:already unstable there:+"; do
  # shellcheck disable=SC2086 # a range
  set -- ${range%%:*}
  answers none speed --lowest "$1" --highest "$2"
  said=${range#*:}
  grep -q "\"growth_lowest\": \"${said%:*}\"" none.json || fail "no critical speed from $1 to $2"
  [ "$(awk -F, 'NR == 2 {print $2 < 0 ? "-" : "+"}' none/speed.csv)" = "${said#*:}" ] && near "growth at $1" "$(v none growth_lowest)" "$(awk -F, 'NR == 2 {print $2}' none/speed.csv)" 1e-5
  near "critical speeds" "$(v none critical_speeds)" 0 0
done
grep -q '"hopf_m_per_s": "[0-9.]* ft/s"' cycle.json || fail "the critical speed in feet"
awk -v m="$(v cycle hopf_m_per_s)" -v f="$(sed -n 's/.*"hopf_m_per_s": "\([0-9.]*\) ft.s".*/\1/p' cycle.json)" 'BEGIN {exit sprintf("%#.4g", m / 0.3048) != f}' || fail "the critical speed in feet"
. "$cases/hunting-profiles.sh"
# shellcheck disable=SC2086 # options
answers cone geometry $cones
means cone 'u = 34; for (k = 0; k < 60; ++k) u = 33 + ((14 - u ^ 2 / 600) / 3) ^ 0.5; l = 717.5 + u - 15; is("contact_mm", l, 1e-5); d = 0.05; is("delta_rad", atan2(d, 1), 1e-6); is("radius_mm", 450); is("slope_R", d * (l + 300 * d) / (l - 450 * d), 1e-4)
  is("slope_Phi", 752 * d / (l - 450 * d), 1e-5); is("slope_D", 0, 1e-3); is("conicity_at_1_mm", d * (l + 300 * d) / (l - 450 * d), 1e-4); is("jumps", 0); is("wheel_rms_mm", 0); is("rail_rms_mm", 0); says("pair", "^cone.csv on head.csv")'
# A wheel with ripples of 1 mm touches from ripple to ripple: the summary names twelve such jumps, the file all.
awk -F, '/^[#i]/ {print; next} {printf "%.3f,%.4f\n", $1, $2 + ($1 < 10) * 0.02 * sin(6.2831853 * $1)}' new-wheel.csv >rippled.csv
draws rippled geometry --wheel rippled.csv --rail worn-rail.csv --noise 0mm --end 8mm --step 0.05mm
awk -F, 'NR > 1 && NR <= 13 {print $1}' rippled/jumps.csv >first
sed -n 's/.*"jump_[0-9]*_mm": \([-0-9][-0-9.e]*\).*/\1/p' rippled.json >named
near "all jumps of a rippled wheel" "$(v rippled jumps)" $(($(wc -l <rippled/jumps.csv) - 1)) 0
[ "$(wc -l <rippled/jumps.csv)" -gt 14 ] && paste first named | awk '{d = $1 - $2; n += d < 1e-3 && d > -1e-3} END {exit !(NR == 12 && n == 12)}' ||
  fail "jumps of a rippled wheel: $(paste first named)"
# Of two unlike radii the wheelset rests where both sides roll alike, towards the smaller wheel.
for radius in 450.1:1 449.9:-1; do
  # shellcheck disable=SC2086 # options
  answers rest speed $cones --average 0mm --right-radius "${radius%:*}mm"
  grep -q "\"pair_right\": \"cone.csv on head.csv, radius ${radius%:*} mm against 450\"" rest.json || fail "the right side: $(grep pair_right rest.json)"
  sed -n 's/.*"rest_mm": "\(.*\) mm to the left".*/\1/p' rest.json | awk -F', ' -v sign=${radius#*:} '{for (k = 1; k <= 4; ++k) {x = $k * sign * 2 * 0.0526 / 0.1; if (!(x > 0.9 && x < 1.1)) exit 1}} END {exit NR != 1}' || fail "at rest: $(grep rest_mm rest.json)"
done
# Measured points are met as closely as is asked, else three times as far as they scatter; a number that hangs on that is told with those of half, of twice, and of their own scatter.
worn="--wheel worn-wheel.csv --rail new-rail.csv --end 4mm --step 0.1mm"
for noise in 0.002 0.004 0.008 own; do
  # shellcheck disable=SC2046,SC2086 # options
  answers worn$noise geometry $worn $([ $noise = own ] || echo "--noise ${noise}mm")
  [ $noise = own ] || near "the rms of a wheel" "$(v worn$noise wheel_rms_mm)" "$noise" 1e-7
done
for part in wheel rail; do
  scatter=$(sed -n "s/.*\"${part}_rms_mm\": \".*scatter of the points \([0-9.]*\) mm, smoothed by 3 times that\".*/\1/p" wornown.json)
  near "the rms of a $part" "$(v wornown ${part}_rms_mm)" "$(awk -v s="$scatter" 'BEGIN {print 3 * s}')" "$(awk -v s="$scatter" 'BEGIN {print 0.1 * s}')"
  grep -q "\"${part}_rms_mm\": \".*scatter of the points [0-9.]* mm\"" worn0.004.json || fail "the scatter of a $part"
done
for number in slope_R:slope_R:0.1:0.01 conicity_at_1_mm:conicity_at_1_mm:0.05:0.005 conicity_at_3_mm:conicity_at_3_mm:0.05:0.005; do
  key=${number%%:*}
  awk -v u="$(v worn0.004 "$key")" -v half="$(v worn0.002 "$key")" -v twice="$(v worn0.008 "$key")" -v own="$(v wornown "$key")" -v r="$(echo "$number" | cut -d: -f3)" -v a="${number##*:}" 'BEGIN {
    n = split(half " smoothed half as much|" twice " twice as much|" own " smoothed as the points'"'"' scatter asks for", all, "|")
    for (k = 1; k <= n; ++k) {x = all[k] + 0; d = x - u; if (d < 0) d = -d; if (d > r * u && d > a) {text = text sprintf(", %.4g", x) substr(all[k], index(all[k], " "))}}
    if (text != "") printf ": %.4g%s\"", u, text; else printf "\"none\""}' >expected
  if [ "$(cat expected)" = '"none"' ]; then
    sed -n '/"warnings"/,$p' worn0.004.json | grep -q "\"$key\":" && fail "$key has a warning"
  else
    grep -q -F "$(cat expected)" worn0.004.json || fail "$key: $(cat expected), not $(sed -n '/"warnings"/,$p' worn0.004.json | grep "$key")"
  fi
done
sed -n '/"warnings"/,$p' worn0.004.json | grep -q "depends on the smoothing" || fail "nothing depends on the smoothing"
# Of a cycle the largest of what the four wheelsets have is told, and all four.
near "cycles at a speed" "$(v cycle cycles)" 1 0
near "the largest amplitude" "$(v cycle cycle_1_mm)" "$(for k in 1 2 3 4; do v cycle cycle_1_wheelset_${k}_mm; done | sort -g | tail -1)" 1e-9
for key in L_over_V creep; do
  sed -n "s/^  \"cycle_1_$key\": \"\([0-9.]*, [0-9.]*, [0-9.]*, [0-9.]*\)[ m;\"].*/\1/p" cycle.json | awk -F', ' -v x="$(v cycle cycle_1_$key)" '{for (k = 1; k <= 4; ++k) if ($k > most) most = $k} END {d = most - x; exit !(NR == 1 && d <= 6e-4 && d >= -6e-4)}' ||
    fail "$key of a cycle: $(grep "cycle_1_$key" cycle.json)"
done
