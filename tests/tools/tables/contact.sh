# Sourced by tables.sh.
# Pressures add up to the load.
answers press solve --body-1-radius-along 460mm --body-2-radius-across 300mm --load 80kN --cells-x 63 --cells-y 63
holds "pressures" press/pressure.csv '
  NF == 3 {if ($1 > x && rows > 1) dx = $1 - x; if ($2 > y && rows > 1) dy = $2 - y; x = $1; y = $2; sum += $3; if ($3 > most) most = $3}
  END {near(sum * abs(dx * dy) / 80e3, 1, 1e-3); near(most / p, 1, 2e-3)}' p="$(v press p_max_MPa)"
awk 'NF == 0 {++breaks} END {exit !(breaks == 63 || breaks == 62)}' press/pressure.csv || fail "an empty line between the rows of a map"
answers inches solve --body-1-radius-along 460mm --body-2-radius-across 300mm --load 80kN --cells-x 63 --cells-y 63 --system inch
for unit in approach_mil:approach_um:25.4 force_lbf:force_kN:0.0044482216 p_max_psi:p_max_MPa:0.0068947573 area_in2:area_mm2:645.16 x_max_in:x_max_mm:25.4; do
  near "$unit" "$(awk -v i="$(v inches "${unit%%:*}")" -v u="${unit##*:}" -v m="$(v press "$(echo $unit | cut -d: -f2)")" 'BEGIN {print i * u / m}')" 1 1e-7
done
# Bodies turned to one another: the ends are those of Hertz's ellipse in its own axes.
answers turned solve --body-1-radius-along 200mm --body-2-radius-across 500mm --body-2-radius-along 400mm --angle 30deg --load 80kN
eval "$(awk -v a="$(v turned hertz_a_mm)" -v b="$(v turned hertz_b_mm)" -v g="$(v turned grid_angle_deg)" 'BEGIN {
  c = cos(g / 57.2957795); s = sin(g / 57.2957795)
  print "x=" sqrt((a * c) ^ 2 + (b * s) ^ 2), "y=" sqrt((a * s) ^ 2 + (b * c) ^ 2)}')"
for end in x_min:-"$x" x_max:"$x" y_min:-"$y" y_max:"$y"; do
  near "${end%%:*} of turned bodies" "$(v turned "${end%%:*}_mm")" "${end#*:}" 0.06
done
# The ends state their errors, which cover Hertz's; first touch of radii is exact, that of a profile is within its error.
sed -n '/"errors": {/,/}/s/^ *"\(x_max_mm\|x_touch_mm\)": \([0-9.e-]*\),*$/\1 \2/p' turned.json >ends
awk -v off="$(v turned x_max_mm)" -v x="$x" '$1 == "x_max_mm" {d = off - x; bad = !(d <= $2 && -d <= $2 && $2 < 0.02 * x); n++} $1 == "x_touch_mm" && $2 != 0 {bad = 1} END {exit bad || n != 1}' ends || fail "errors of the ends: $(cat ends)"
# A profile whose lowest place is not at its zero: the contact is about that place, and else Hertz's.
awk 'BEGIN {print "x_mm,depth_mm"; for (i = -200; i <= 200; ++i) {x = i / 10; printf "%.1f,%.9f\n", x, (x - 7) ^ 2 / 600}}' >aside.csv
answers aside solve --body-2-profile aside.csv --body-1-radius-along 460mm --load 80kN
for place in x_touch x_p_max; do near "$place of a profile" "$(v aside ${place}_mm)" 7 0.01; done
for end in x_min x_max y_min y_max; do
  near "$end of a profile" "$(v aside ${end}_mm)" "$(awk -v e="$(v press ${end}_mm)" -v at=${end%_*} 'BEGIN {print e + (at == "x" ? 7 : 0)}')" 0.2
done
near "pressure of a profile" "$(v aside p_max_MPa)" "$(v press p_max_MPa)" 3
sed -n '/"errors": {/,/}/s/^ *"x_touch_mm": \([0-9.e-]*\),*$/\1/p' aside.json | awk '{ok = $1 >= 1e-9 && $1 < 0.05} END {exit !ok || NR != 1}' || fail "the error of first touch of a profile"
# One that ends, on either side, within the contact is refused.
for end in '$1 < 10' '$1 > 4'; do
  awk -F, "NR == 1 || $end" aside.csv >cut.csv
  "$railbook" contact solve --body-2-profile cut.csv --body-1-radius-along 460mm --load 80kN >said 2>&1
  [ $? = 2 ] && grep -q "end of the profile data, x = $(awk -F, 'NR == 2 {printf "%g m", $1 / 1e3} END {printf " to %g m", $1 / 1e3}' cut.csv);" said || fail "a profile that is cut off: $(cat said)"
done
# Crossed cylinders of one radius touch in a circle: Hertz by hand, of two materials, by load and by approach, in either system of units.
circle='e = 1 / ((1 - 0.25 ^ 2) / 200e9 + (1 - 0.35 ^ 2) / 100e9); R = 0.4; a = (0.75 * F * R / e) ^ (1 / 3); depth = a ^ 2 / R; p = 1.5 * F / (pi * a ^ 2)
  U = shown == "inch" ? 25.4 : 1; S = shown == "inch" ? 25.4 : 1; P = shown == "inch" ? 6894.757293168 : 1e6; N = shown == "inch" ? 4.4482216152605 : 1e3
  l = shown == "inch" ? "in" : "mm"; s = shown == "inch" ? "mil" : "um"; q = shown == "inch" ? "psi" : "MPa"; f = shown == "inch" ? "lbf" : "kN"
  is("effective_modulus_" q, e / P); is("x_touch_" l, 0); is("approach_" s, 1e6 * depth / S, 1e-3); is("force_" f, F / N, 1e-3); is("moment_x", 0); is("moment_y", 0); is("p_max_" q, p / P, 2e-3)
  is("x_p_max_" l, 0, 1e-6); is("y_p_max_" l, 0, 1e-6); is("x_min_" l, -1e3 * a / U, 0.02); is("x_max_" l, 1e3 * a / U, 0.02); is("y_min_" l, -1e3 * a / U, 0.02); is("y_max_" l, 1e3 * a / U, 0.02)
  is("area_" l "2", pi * 1e6 * a ^ 2 / U ^ 2, 0.01); is("patches", 1); says("grid", "^63 x 65 cells, " cells " in contact"); free("iterations"); free("transform_pairs")
  is("hertz_approach_" s, 1e6 * depth / S); is("hertz_force_" f, F / N); is("hertz_p_max_" q, p / P); is("hertz_a_" l, 1e3 * a / U); is("hertz_b_" l, 1e3 * a / U)
  says(way == "load" ? "hertz_force_" f : "hertz_approach_" s, "as asked"); says(way == "load" ? "hertz_approach_" s : "hertz_force_" f, "the grid is off by")'
bodies="--body-1-radius-along 400mm --body-2-radius-across 400mm --body-1-young 200GPa --body-1-poisson 0.25 --body-2-young 100GPa --body-2-poisson 0.35 --cells-x 63 --cells-y 65"
# shellcheck disable=SC2086 # options
draws by-load solve $bodies --load 80kN
depth=$(awk 'BEGIN {e = 1 / (0.9375 / 200e9 + 0.8775 / 100e9); printf "%.12g", (0.75 * 80e3 * 0.4 / e) ^ (2 / 3) / 0.4}')
# shellcheck disable=SC2086 # options
answers by-approach solve $bodies --approach "${depth}m" --system inch
means by-load "$circle" F=80e3 way=load shown=metric cells="$(awk -F, 'NR > 1 && $3 > 0 {++n} END {print n}' by-load/pressure.csv)"
means by-approach "$circle" F=80e3 way=approach shown=inch cells="$(awk -F, 'NR > 1 && $3 > 0 {++n} END {print n}' by-approach/pressure.csv)"
[ "$(tail -1 by-load.drawn/1/d3.csv)" = "mm,MPa,x across the rail,y along the rail" ] || fail "units of the drawing: $(cat by-load.drawn/1/d3.csv)"
# All cells of the grid are in the map, the outline is the circle, and the same on both sides.
awk -F, 'NR > 1 && NF == 3 {++n; if (!(($1) in x)) ++nx; x[$1]; if (!(($2) in y)) ++ny; y[$2]} END {exit !(n == 63 * 65 && nx == 63 && ny == 65)}' by-load/pressure.csv || fail "cells of the map"
holds "the outline" by-load/outline.csv '{near($2, -$3, 1e-9); near(sqrt($1 ^ 2 + $3 ^ 2) / a, 1, 0.03)} $1 < least {least = $1} $1 > most {most = $1} END {near(least / a, -1, 0.06); near(most / a, 1, 0.06)}' a="$(v by-load hertz_a_mm)"
# Turned bodies are drawn along the principal axes; half as large as a fifth of a radius they cause no warning, beyond it they are.
draws skew solve --body-1-radius-along 200mm --body-2-radius-across 500mm --body-2-radius-along 400mm --angle 30deg --load 80kN --cells-x 30 --cells-y 30
near "a peak of turned bodies" "$(v skew x_p_max_mm)" 0 0
near "a peak of turned bodies" "$(v skew y_p_max_mm)" 0 0
[ "$(tail -1 skew.drawn/1/d3.csv)" = "mm,MPa,first principal axis,second principal axis" ] || fail "axes of turned bodies"
"$railbook" contact solve --body-1-radius-along 10mm --body-2-radius-across 10mm --load 160kN --cells-x 31 --cells-y 31 >wide || fail "a wide contact"
awk '/WARNING: the contact reaches 0\.22 of/ {found = 1} END {exit !found}' wide || fail "a contact of a fifth of its radius: $(cat wide)"
"$railbook" contact solve --body-1-radius-along 100mm --body-2-radius-across 100mm --load 80kN --cells-x 31 --cells-y 31 | grep -q WARNING && fail "a contact of 6 % of its radius"
for way in "--load 200kN:give less load" "--approach 2mm:give less approach"; do
  # shellcheck disable=SC2086 # options
  "$railbook" contact solve --body-1-radius-across 1mm --body-2-radius-along 1mm ${way%%:*} --cells-x 31 --cells-y 31 2>&1 | grep -q "half width of the contact is .* with a radius of 0.001 m across the rail of body 1; .*${way#*:}" || fail "$way"
done
# Half the width is told along each radius: a body turned on a ball, or its radii exchanged, reaches as far of them.
for body in "8mm --body-2-radius-along 300mm:0" "8mm --body-2-radius-along 300mm:30" "8mm --body-2-radius-along 300mm:90" "300mm --body-2-radius-along 8mm:0"; do
  # shellcheck disable=SC2086 # options
  "$railbook" contact solve --body-1-radius-along 20mm --body-1-radius-across 20mm --body-2-radius-across ${body%:*} --angle "${body#*:}deg" --load 300kN | sed -n 's/.*contact reaches \([0-9.]*\) of.*/\1/p'
done | xargs | awk '{for (k = 2; k <= 4; ++k) if ($k > 1.05 * $1 || $k < 0.95 * $1) exit 1; exit NF != 4}' || fail "turned on a ball"
# The radius changes where the profile is lowest: a moment, and that of the pressures; a cell begins at the edge asked for.
awk 'BEGIN {print "x_mm,height_mm"; for (i = -400; i <= 400; ++i) {x = i / 20; printf "%.2f,%.9f\n", x + 5, -x ^ 2 / (x < 0 ? 600 : 200)}}' >two-radii.csv
answers uneven solve --body-2-profile two-radii.csv --body-1-radius-along 460mm --load 80kN --cells-x 64 --cells-y 33 --edge 5mm
holds "an uneven contact" uneven/pressure.csv 'NF == 3 && !(($1) in seen) {seen[$1]; if (columns++ > 0) dx = $1 - before; before = $1} NF == 3 {if ($2 != row && row != "") dy = $2 - row; row = $2; sum += $3; turn += ($1 - touch) * $3; if ($3 > most) {most = $3; at = $1}}
  END {near(touch, 5, 0.01); near(turn * dx * dy / 1e3, m, 0.01 * abs(m)); near(m < -1, 1, 0); near(sum * dx * dy / 80e3, 1, 2e-3); near(at, peak, dx); e = (before - 5) / dx; near(e - int(e), 0.5, 1e-3)}' \
  touch="$(v uneven x_touch_mm)" m="$(v uneven moment_y)" peak="$(v uneven x_p_max_mm)"
near "a moment about x" "$(v uneven moment_x)" 0 0
holds "where it begins and ends" uneven/pressure.csv 'NF == 3 && $3 > 0 {if (first == "" || $1 < first) first = $1; if (last == "" || $1 > last) last = $1}
  END {near(first, from, 0.2); near(last, to, 0.2); near(to - touch < 0.8 * (touch - from), 1, 0)}' from="$(v uneven x_min_mm)" to="$(v uneven x_max_mm)" touch="$(v uneven x_touch_mm)"
grep -q hertz uneven.json && fail "Hertz for a profile"
# Heights are depths of the other sign.
awk -F, 'NR == 1 {print "x_mm,depth_mm"} NR > 1 {printf "%s,%.9f\n", $1, -$2}' two-radii.csv >depths.csv
answers down solve --body-2-profile depths.csv --body-1-radius-along 460mm --load 80kN --cells-x 64 --cells-y 33 --edge 5mm
cmp uneven/pressure.csv down/pressure.csv || fail "depths, and heights of the other sign"
# Three summits 20 mm apart: alike, each with its ends and a share of the whole.
awk 'BEGIN {print "x_mm,depth_mm"; for (k = 0; k <= 240; ++k) {u = (k % 80 - 40) / 4; printf "%.2f,%.9f\n", (k - 120) / 4, u ^ 2 / 500}}' >summits.csv
answers three solve --body-1-profile summits.csv --body-1-radius-along 0.5m --approach 20um --cells-x 200 --cells-y 30
means three 'for (key in v) free(key); is("patches", 3); says("patches", "apart"); sum = area = 0; for (k = 1; k <= 3; ++k) {sum += v["patch_" k "_force_kN"]; area += v["patch_" k "_area_mm2"]}
  is("force_kN", sum, 0.01); is("area_mm2", area, 0.01); for (k = 1; k <= 3; ++k) {middle = (v["patch_" k "_x_min_mm"] + v["patch_" k "_x_max_mm"]) / 2; place[k] = middle; outer += abs(middle) > 1
    is("patch_" k "_y_min_mm", -v["patch_" k "_y_max_mm"], 1e-3); is("patch_" k "_p_max_MPa", v["p_max_MPa"], 0.1); if (abs(middle) > 1 && abs(abs(middle) - 20) > 0.2) bad("place " middle)}
  if (outer != 2) bad("places")'
# Where the grid's error is not known that of the profiles does not say it.
answers thin solve --body-1-profile summits.csv --body-1-radius-along 0.5m --approach 2um --cells-x 40 --cells-y 4
[ "$(grep -c '": "error not known; of this grid' thin.json)" = 2 ] && [ "$(grep -c '_m[a-z]*_mm": "error not known"' thin.json)" = 4 ] && [ "$(sed -n '/"errors"/,/}/p' thin.json | grep -c '"\(x\|y\)_m[a-z]*_mm": null\|"\(force_kN\|p_max_MPa\)": null')" = 6 ] && grep -q '"profile"' thin.json || fail "an error that is not known"
# What a profile's points leave open is what every second of them alone would change, the odd ones or the even ones, at one approach: twice the worst of force and
# pressure for the pressure.
awk 'BEGIN {print "x_mm,depth_mm"; for (k = -20; k <= 20; ++k) {u = (5 * k - 1) / 10; printf "%.1f,%.9f\n", u, u ^ 2 / (u > 0 ? 60 : 500)}}' >coarse.csv
awk 'NR == 1 || NR % 2 == 0' coarse.csv >even.csv
awk 'NR <= 2 || NR % 2 == 1 || NR == 42' coarse.csv >odd.csv
for points in coarse even odd; do answers $points solve --body-1-profile $points.csv --body-1-radius-along 0.5m --approach 20um --cells-x 100 --cells-y 60; done
awk -v F="$(v coarse force_kN)" -v F1="$(v even force_kN)" -v F2="$(v odd force_kN)" -v p="$(v coarse p_max_MPa)" -v p1="$(v even p_max_MPa)" -v p2="$(v odd p_max_MPa)" 'function abs(x) {return x < 0 ? -x : x} function max(x, y) {return x > y ? x : y}
  BEGIN {f = max(abs(F1 / F - 1), abs(F2 / F - 1)); q = 2 * max(f, max(abs(p1 / p - 1), abs(p2 / p - 1))); printf "force by %.1e, the peak pressure by %.1e of it\n", f, q}' >open
grep -q "$(cat open)" coarse.json || fail "not $(cat open): $(grep 'every second' coarse.json)"
# Cells that are not even about the middle put the peak a little beside it, along the first principal axis, which the answer turns back.
answers aside solve --body-1-radius-along 200mm --body-2-radius-across 500mm --body-2-radius-along 400mm --angle 60deg --load 80kN --cells-x 8 --cells-y 9 --edge 1mm
awk -v x="$(v aside x_p_max_mm)" -v y="$(v aside y_p_max_mm)" -v g="$(v aside grid_angle_deg)" 'BEGIN {g /= 57.29577951308232; d = y * cos(g) - x * sin(g); exit !(x * x > 1e-6 && d * d < 1e-12 && x * x + y * y < 0.01)}' || fail "a peak of turned bodies: $(grep p_max_mm aside.json)"
awk -F, -v x="$(v aside x_p_max_mm)" -v g="$(v aside grid_angle_deg)" 'NF == 3 && $3 > most {most = $3; at = $1} END {exit !((x / cos(g / 57.29577951308232) - at) ^ 2 < 1)}' aside/pressure.csv || fail "a peak that is not where the pressures are largest"
# Rounded points: the first touch is where they happen to be high, and the answer says how far off that may be. Hertz by hand.
for digits in 4 5 12; do
  awk -v d=$digits 'BEGIN {print "x_mm,depth_mm"; for (i = -200; i <= 200; ++i) {x = i / 20; printf "%.2f,%." d "f\n", x, 300 - sqrt(9e4 - (x - 0.013) ^ 2)}}' >round.csv
  answers round$digits solve --body-1-profile round.csv --body-1-radius-along 460mm --approach 60um
  near "the error of a force from profiles with $digits digits" "$(v round$digits force_kN)" 43.1948 "$(sed -n '/"errors"/,/}/s/.*"force_kN": \([0-9.e-]*\),*/\1/p' round$digits.json)"
done
grep -q '"scatter": "the points of the profiles scatter' round4.json || fail "rounded points have no warning"
grep -q '"scatter"' round12.json && fail "points of twelve digits scatter"
# A load has no error where it was asked for; the approach has it.
sed -n '/"errors"/,/}/p' press.json | grep -q '"approach_um": [0-9.e-]*' || fail "an approach without its error"
sed -n '/"errors"/,/}/p' press.json | grep -q '"force_kN"' && fail "an error of a load that was asked for"
# What help says of each body is said of that one.
"$railbook" contact solve --help | tr -s ' \n' ' ' | sed 's/ \[\([^]]*\)\]/=\1/g' >help # as CLI11 of Debian 12 writes it
for body in 1 2; do
  for what in "radius-across QUANTITY radius across the rail of body @, negative" "radius-along QUANTITY radius along the rail of body @; straight" "profile FILE profile across the rail of body @:" \
    "young QUANTITY=2.1e+11 Pa Young's modulus of body @ " "poisson QUANTITY=0.28 Poisson's ratio of body @ "; do
    grep -q -F -e "--body-$body-$(echo "$what" | sed "s/@/$body/")" help || fail "--help does not say $what of body $body"
  done
done
# A hollow at 45 degrees to a ball's axes: it is the hollow's radius that the long axis is nearest to, that of the ball when they are along each other.
for case in 45:25 0:20; do
  answers hollow solve --body-1-radius-along 20mm --body-1-radius-across 20mm --body-2-radius-across=-25mm --body-2-radius-along 300mm --angle "${case%:*}deg" --load 150kN
  near "the share of a radius" "$(sed -n 's/.*contact reaches \([0-9.]*\) of.*/\1/p' hollow.json)" "$(awk -v a="$(v hollow hertz_a_mm)" -v r="${case#*:}" 'BEGIN {print a / r}')" 0.012
done
