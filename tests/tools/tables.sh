#!/bin/sh
# tables.sh SUBJECT RAILBOOK: the tables that tools write say what their answers say, and keep the laws of what they are about.
subject=$1 railbook=$2
folder=$(mktemp -d) || exit 1
trap 'rm -rf "$folder"' EXIT
cd "$folder" || exit 1
fail() { echo "$*"; exit 1; }
# answers FOLDER arguments...: files in FOLDER, the answer as JSON in FOLDER.json.
answers() {
  to=$1
  shift
  "$railbook" "$subject" "$@" --no-figures --out "$to" --json >"$to.json" 2>said || fail "$*: $(cat said)"
  sed '/"flags": {/q' "$to.json" | grep '^  "[^"]* [^"]*": ' && fail "$*: a key with a space in it"
}
# v FOLDER KEY: a number of the answer.
v() { sed -n "s/^  \"$2\": \(-\?[0-9][0-9.e+-]*\),\?\$/\1/p" "$1.json" | head -1; }
# near WHAT VALUE EXPECTED WITHIN
near() { awk -v a="$2" -v b="$3" -v within="$4" 'BEGIN {exit !(a != "" && a - b <= within && b - a <= within)}' || fail "$1: $2 is not $3"; }
# holds WHAT FILE PROGRAM assignments...: an awk program over a CSV, columns by name in c, that counts what is wrong in `wrong`.
holds() {
  what=$1 file=$2 program=$3
  shift 3
  # shellcheck disable=SC2046 # one word each
  awk $(for one in "$@"; do echo "-v $one"; done) -F, 'function abs(x) {return x < 0 ? -x : x}
    function near(x, y, within) {if (y == "" || !(abs(x - y) <= within)) {print x, "is not", y; wrong++}}
    NR == 1 {for (i = 1; i <= NF; ++i) c[$i] = i; next} {++rows} '"$program"' END {exit wrong > 0 || rows == 0}' "$file" >said ||
    fail "$what: $(head -5 said)"
}

case $subject in
hunting)
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
  answers cycle cycle --pair cn --largest-amplitude 3mm --wheel-rail-friction 0.3
  extent=$(sed -n 's/^  "branch_extent": "\([0-9.]*\) to \([0-9.]*\) m.s, \([0-9.]*\) to \([0-9.]*\) mm",\?$/a=\1 b=\2 c1=\3 d=\4/p' cycle.json)
  # shellcheck disable=SC2086
  holds "a branch of cycles" cycle/cycle.csv '
    rows == 1 {slow = fast = $2; small = large = $3; near($2, hopf, 1); near($3, 1, 0.05)}
    $2 < slow {slow = $2} $2 > fast {fast = $2} $3 < small {small = $3} $3 > large {large = $3}
    {near($c["L_over_V"] > 0 && $c["creep_over_friction"] > 0 && $c["creep_over_friction"] < 1, 1, 0)
     near(($c["stable_mm"] == "nan") + ($c["unstable_mm"] == "nan"), 1, 0); near($c["front_leading_mm"], $3, 1e-6)}
    END {near(slow, a, 1e-4); near(fast, b, 1e-4); near(small, c1, 1e-4); near(large, d, 1e-4); near(rows, n, 0)}' \
    $extent hopf="$(v cycle hopf_m_per_s)" n="$(v cycle branch_points)"
  ;;
track)
  # From 5 ms before the joint; the peaks are those of the answer, and the joint is the lowest place of the surface.
  answers joint joint --speed 60mph --dip 0.5in --duration 40ms
  holds "force over a joint" joint/joint.csv '
    rows == 1 {near($1, -5, 1e-6); least = $2} {last = $1} $1 <= 2.5 && $2 > second {second = $2}
    $1 >= 4 && $2 > late {late = $2} $2 < least {least = $2} $6 > deepest {deepest = $6; at = $1}
    END {near(last, 40, 1e-6); near(second, s, 0.1); near(late, l, 0.1); near(least, w, 0.1); near(deepest, 12.7, 0.01); near(at, 0, 0.03)}' \
    s="$(v joint second_kN)" l="$(v joint late_kN)" w="$(v joint least_kN)"
  # What the bed bears is the wheel load; the rail is symmetrical about the wheel, and deepest under it.
  answers bend stiffness --wheel-load 100kN
  holds "deflected rail" bend/stiffness.csv '
    {x[rows] = $1; y[rows] = $2; q[rows] = $3; if ($2 > deepest) {deepest = $2; at = $1}}
    END {for (i = 1; i <= rows; ++i) near(y[i], y[rows + 1 - i], 1e-5)
      for (i = 2; i <= rows; ++i) sum += (x[i] - x[i - 1]) * (q[i] + q[i - 1]) / 2
      near(sum, 100, 0.3); near(at, 0, 1e-6); near(deepest, d, 1e-4)}' d="$(v bend deflection_mm_at_0.000)"
  ;;
contact)
  # Pressures add up to the load.
  answers press solve --body-1-radius-along 460mm --body-2-radius-across 300mm --load 80kN --cells-x 63 --cells-y 63
  holds "pressures" press/pressure.csv '
    NF == 3 {if ($1 > x && rows > 1) dx = $1 - x; if ($2 > y && rows > 1) dy = $2 - y; x = $1; y = $2; sum += $3; if ($3 > most) most = $3}
    END {near(sum * abs(dx * dy) / 80e3, 1, 1e-3); near(most / p, 1, 2e-3)}' p="$(v press p_max_MPa)"
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
  # A profile whose lowest place is not at its zero: the contact is about that place, and else Hertz's.
  awk 'BEGIN {print "x_mm,depth_mm"; for (i = -200; i <= 200; ++i) {x = i / 10; printf "%.1f,%.9f\n", x, (x - 7) ^ 2 / 600}}' >aside.csv
  answers aside solve --body-2-profile aside.csv --body-1-radius-along 460mm --load 80kN
  for place in x_touch x_p_max; do near "$place of a profile" "$(v aside ${place}_mm)" 7 0.01; done
  for end in x_min x_max y_min y_max; do
    near "$end of a profile" "$(v aside ${end}_mm)" "$(awk -v e="$(v press ${end}_mm)" -v at=${end%_*} 'BEGIN {print e + (at == "x" ? 7 : 0)}')" 0.2
  done
  near "pressure of a profile" "$(v aside p_max_MPa)" "$(v press p_max_MPa)" 3
  # One that ends, on either side, within the contact is refused.
  for end in '$1 < 10' '$1 > 4'; do
    awk -F, "NR == 1 || $end" aside.csv >cut.csv
    "$railbook" contact solve --body-2-profile cut.csv --body-1-radius-along 460mm --load 80kN >said 2>&1
    [ $? = 2 ] && grep -q "profile" said || fail "a profile that is cut off: $(cat said)"
  done
  ;;
creep)
  # Friction bounds what creeps, and more creepage is more force, from Kalker's slope on.
  answers creep curve --a 6mm --b 4mm --load 80kN --theory fastsim --points 9
  holds "a creep curve" creep/curve.csv '
    {near($2, 0, 0); near($c["fy_N"], 0, 1e-6); f = $c["fx_N"]} f > 24000.001 || (rows > 1 && f < last) || (rows == 2 && !(f > 1000)) {wrong++} {last = f} END {near(rows, 9, 0)}'
  ;;
filters)
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
  ;;
psd)
  # 4 mm of a wave of 6 m, and waves of 1 m and 60 m: the band of 3 to 25 m has the first alone.
  awk 'BEGIN {print "distance_m,profile_mm"; for (i = 0; i < 12000; ++i) {w = 2 * 3.14159265358979 * i / 4
    printf "%.2f,%.4f\n", i / 4, 4 * sin(w / 6) + 2 * sin(w) + 6 * sin(w / 60) + 0.1 * sin(i * i)}}' >waves.csv
  answers rms classify waves.csv --reference fra-5
  near "rms of waves of 3 to 25 m" "$(v rms rms_3_25_mm)" 2.83 0.05
  ;;
quality)
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
  ;;
wheelrail)
  # In the mirror left is right; what lies across, and moments about the other axes, change their signs.
  answers here contact --load 50kN --speed 30m/s --shift 4mm --yaw 5mrad --method strips
  answers there contact --load 50kN --speed 30m/s --shift -4mm --yaw -5mrad --method strips
  near "turning" "$(v here turning_rad_per_s)" "$(v there turning_rad_per_s)" 1e-6
  near "roll" "$(v here roll_mrad)" "$(awk -v r="$(v there roll_mrad)" 'BEGIN {print -r}')" 1e-5
  for key in x_N z_N y_N 1_x_mm 1_y_mm 1_angle_mrad 1_normal_N 1_p_max_MPa 1_creepage_x 1_creepage_y 1_spin_1_per_m 1_fx_N 1_fy_N 1_mz_N_m 1_wear_N; do
    for side in left:right right:left; do
      awk -v key="$key" -v a="$(v here "${side%:*}_$key")" -v b="$(v there "${side#*:}_$key")" 'BEGIN {
        if (key ~ /y_|_y|angle|spin|mz/) b = -b
        d = a < b ? b - a : a - b; size = a < 0 ? -a : a; exit !(a != "" && d <= 1e-4 * size + 1e-4)}' || fail "$side $key: $(v here "${side%:*}_$key"), $(v there "${side#*:}_$key")"
    done
  done
  near "load" "$(v here left_z_N)" 50e3 50
  # Left is on the left; the cells' largest pressure is the answer's, and their shear within FASTSIM's parabola, 4/3 as high.
  awk -v l="$(v here left_1_y_mm)" -v r="$(v here right_1_y_mm)" 'BEGIN {exit !(l < -700 && r > 700)}' || fail "left and right"
  holds "cells of the patches" here/patches.csv '
    $c["pressure_MPa"] > most[$1] {most[$1] = $c["pressure_MPa"]} {t = sqrt($c["shear_x_MPa"] ^ 2 + $c["shear_y_MPa"] ^ 2)}
    t > 0.3 * 4 / 3 * $c["pressure_MPa"] * 1.01 + 1 {print t " on " $c["pressure_MPa"]; wrong++}
    END {near(most["left"] / l, 1, 0.01); near(most["right"] / r, 1, 0.01)}' l="$(v here left_1_p_max_MPa)" r="$(v here right_1_p_max_MPa)"
  ;;
*) fail "no tables of $subject are known" ;;
esac
exit 0
