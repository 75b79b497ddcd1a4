# Sourced by tables.sh.
# Friction bounds what creeps, and more creepage is more force, from Kalker's slope on.
answers creep curve --a 6mm --b 4mm --load 80kN --theory fastsim --points 9
holds "a creep curve" creep/curve.csv '
  {near($2, 0, 0); near($c["fy_N"], 0, 1e-6); f = $c["fx_N"]} f > 24000.001 || (rows > 1 && f < last) || (rows == 2 && !(f > 1000)) {wrong++} {last = f} END {near(rows, 9, 0)}'
# Bodies of two materials whose contact is a circle: curvatures 1/0.5 + 1/2 along and 1/(1/3) - 1/2 across, 1/0.4 m either way. Hertz's circle,
# and the moduli of Kalker's half spaces: 2/G = 1/G1 + 1/G2, 2 nu/G = nu1/G1 + nu2/G2.
materials="--wheel-young 200GPa --wheel-poisson 0.25 --rail-young 100GPa --rail-poisson 0.35"
# shellcheck disable=SC2086 # options
answers round curve --wheel-radius 0.5m --rail-radius 2m --wheel-profile -2m --rail-crown 333.333333333333mm --load 80kN --mu 0.25 $materials \
  --theory linear --from 1e-4 --to 3e-4 --points 3 --lateral 2e-4 --spin 0.3rad/m --force 2kN
means round 'e = 1 / (0.9375 / 200e9 + 0.8775 / 100e9); a = (0.75 * 80e3 * 0.4 / e) ^ (1 / 3); G = 2 / (1 / 80e9 + 2.7 / 100e9)
  is("p_max_MPa", 1.5 * 80e3 / (pi * a ^ 2) / 1e6); is("a_mm", 1e3 * a); is("b_mm", 1e3 * a); says("a_mm", "Hertz"); says("b_mm", "Hertz"); says("theory", "linear")
  is("load_kN", 80); is("friction", 0.25); is("shear_modulus_GPa", G / 1e9); is("poisson", G / 2 * (0.25 / 80e9 + 0.35 * 2.7 / 100e9))
  warns("similarity", sprintf("K = %.3f", G / 4 * (0.5 / 80e9 - 0.3 * 2.7 / 100e9))); is("lateral", 2e-4); is("spin_1_per_m", 0.3); is("force_N", 2000)
  is("largest_force_N", largest, 1e-5); is("creepage_at_force", 2000 / slope, 1e-6); is("error_share", error, 0.06); free("mz_error_N_m"); warnings("range_1")' \
  error="$(awk -F, 'NR > 1 && $8 > most {most = $8} END {print most}' round/curve.csv)" slope="$(awk -F, 'NR == 3 {printf "%.9g", $4 / $1}' round/curve.csv)" largest="$(awk -F, 'NR > 1 {f = sqrt($4 ^ 2 + $5 ^ 2); if (f > most) most = f} END {printf "%.9g", most}' round/curve.csv)"
# A line through the origin, whose forces across do not depend on what goes along, and the warning in every row beyond a third of friction.
holds "a line" round/curve.csv 'rows == 1 {f = $4; y = $5} {near($1, rows * 1e-4, 1e-12); near($2, 2e-4, 1e-12); near($3, 0.3, 1e-9); near($4, rows * f, 0.01 * abs(f)); near($5, y, 1e-6 * abs(y))}
  {near(($10 != ""), sqrt($4 ^ 2 + $5 ^ 2) > 80e3 * 0.25 / 3, 0); near($8 > 0 && $9 > 0, 1, 0)} END {near(rows, 3, 0); near(f > 0, 1, 0)}'
# Without an end the range goes to six times the creepage at which the linear force is that of friction, and all slides there.
for theory in linear vermeulen-johnson; do
  answers end-$theory curve --a 6mm --b 4mm --load 80kN --theory $theory --points 2
done
answers slope curve --a 6mm --b 4mm --load 80kN --theory vermeulen-johnson --from 1e-8 --points 1
slope=$(awk -F, 'END {printf "%.9g", $4 / $1}' slope/curve.csv)
holds "the end of the range" end-vermeulen-johnson/curve.csv 'rows == 2 {near($1 * slope, 6 * 24e3, 1); near($4, 24e3, 1e-4); near($7, 0, 0)} rows == 1 {near($1, 0, 0); near($4, 0, 0)} END {near(rows, 2, 0)}' slope="$slope"
# The full theory says its errors, in each row and the largest of them; the printed table has the share of friction.
"$railbook" creep curve --a 6mm --b 4mm --load 80kN --points 3 --cells 10 --lateral 5e-4 --to 2e-3 --spin 0.2rad/m --no-figures --out full >printed || fail "full"
awk -F, 'NR == 1 {next} $8 > error {error = $8} $9 > moment {moment = $9} END {exit !(error > 0 && moment > 0); }
  function near(x, y) {return x - y <= 0.06 * y && y - x <= 0.06 * y}' full/curve.csv || fail "the full theory's errors"
for pair in error_share:8 mz_error_N_m:9; do
  most=$(awk -F, -v i="${pair#*:}" 'NR > 1 && $i > most {most = $i} END {print most}' full/curve.csv)
  near "$pair" "$(sed -n "s/^  \"${pair%:*}\": \([0-9.e-]*\),*$/\1/p" full/curve.json)" "$most" "$(awk -v m="$most" 'BEGIN {print m / 20}')"
done
tail -3 printed | paste -d' ' - - - >rows
awk -F, 'NR > 1 {printf "%.9g %.3f %.9g ", sqrt($4 ^ 2 + $5 ^ 2) / 24e3, $7, $8}' full/curve.csv >shares
cat rows shares | awk 'NR == 1 {for (k = 1; k <= 3; ++k) {share[k] = $(6 * k - 1); stick[k] = $(6 * k)} next}
  {for (k = 1; k <= 3; ++k) {d = share[k] - $(3 * k - 2); e = $(3 * k) + 1e-9; if (d > e || -d > e || stick[k] != $(3 * k - 1) || length(share[k]) > 7) exit 1}}' ||
  fail "the printed table: $(cat printed)"
# A theory that knows no error of its own is held against the full one, which is off by more than the tenth from which on a row has a warning.
answers against curve --a 6mm --b 4mm --load 80kN --theory linear --points 2
grep -q ',"this theory is more than 0.1 mu N off the full one\|third of what friction bears' against/curve.csv || fail "the linear theory in sliding has no warning"
answers spun curve --a 4mm --b 6mm --load 80kN --theory fastsim --points 2 --to 1e-4 --spin 1rad/m
awk -F, 'NR == 2 {exit !($8 > 0 && $8 < 0.3)}' spun/curve.csv || fail "FASTSIM's distance from the full theory: $(cat spun/curve.csv)"
# Long contacts have fewer rows across and end: with half as many as cells along they did not.
for cells in 24 48 64 96; do
  answers long$cells curve --a 10mm --b 0.1mm --load 100N --from 1e-5 --points 1 --cells $cells
done
cat long*/curve.csv | awk -F, '/^[0-9]/ {if (!n++ || $4 < low) low = $4; if ($4 > high) high = $4; if ($8 > error) error = $8} END {exit !(n == 4 && high - low < 2 * 30 * error)}' || fail "long contacts: $(cat long*/curve.csv)"
# Without friction there is no share of it.
"$railbook" creep curve --a 6mm --b 4mm --load 80kN --mu 0 --to 1e-3 --points 2 --theory fastsim >printed || fail "no friction"
[ "$(tail -2 printed | awk '$5 == "-"' | wc -l)" = 2 ] || fail "a share of no friction: $(tail -2 printed)"
# Contacts that follow a radius: beyond a fifth of it with a warning.
answers wide curve --wheel-radius 0.4m --rail-crown 0.4m --load 300MN --theory linear --points 1 --mu 0 --to 1e-3
means wide 'says("half_space", "reaches 0.23"); for (key in v) free(key)'
answers narrow curve --wheel-radius 0.4m --rail-crown 0.4m --load 150MN --theory linear --points 1 --mu 0 --to 1e-3
grep -q half_space narrow.json && fail "a narrow contact has a warning"
# A table: its axes, its rows, and its errors as they are told; a single ratio is one however many are asked for.
answers table table --theory polach --ratio-from 0.5 --ratio-to 2 --ratios 3 --longitudinal 3 --lateral 4 --spin 5 --reach 2 --spin-reach 3 --points 40 --coefficients computed
grep -v '^#' table/table.csv >nodes.csv
holds "nodes" nodes.csv '{for (k = 1; k <= 4; ++k) {if (rows == 1 || $k < low[k]) low[k] = $k; if (rows == 1 || $k > high[k]) high[k] = $k; if (!(($k, k) in seen)) ++n[k]; seen[$k, k]}}
  $2 == 0 {near($5, 0, 1e-9)} $3 == 0 && $4 == 0 {near($6, 0, 1e-9)} sqrt($5 ^ 2 + $6 ^ 2) > 1 + 1e-6 {wrong++}
  END {near(rows, 180, 0); near(n[1], 3, 0); near(n[2], 3, 0); near(n[3], 4, 0); near(n[4], 5, 0); near(low[1], 0.5, 1e-9); near(high[1], 2, 1e-9)
    near(low[2], 0, 0); near(high[2], 2, 1e-6); near(low[3], 0, 0); near(high[3], 2, 1e-6); near(low[4], -3, 1e-6); near(high[4], 3, 1e-6)}'
means table 'says("theory", "polach"); says("nodes", "^3 axis ratios x 3 x 4 x 5 spins"); is("reach", 2); is("spin_reach", 3); is("error_points", 40); is("within_bound", 40); is("against_full_points", 64)
  free("error_force_largest error_force_rms error_moment_largest error_moment_rms against_full_force_largest against_full_force_rms against_full_moment_largest against_full_moment_rms")
  if (!(v["against_full_force_largest"] > v["against_full_force_rms"] && v["against_full_force_rms"] > 0.01 && v["against_full_force_rms"] < 0.4)) bad("against full")
  if (!(v["error_force_largest"] > v["error_force_rms"] && v["error_moment_largest"] >= v["error_moment_rms"])) bad("rms"); warnings("range")'
error=$(sed -n 's/^# Error of that, of (fx, fy): largest \([0-9.e-]*\), rms \([0-9.e-]*\); of mz: largest \([0-9.e-]*\), rms \([0-9.e-]*\) (40 points off the nodes)..*/\1 \2 \3 \4/p' table/table.csv)
# shellcheck disable=SC2086 # four numbers
set -- $error
for key in error_force_largest error_force_rms error_moment_largest error_moment_rms; do
  near "$key" "$1" "$(v table $key)" "$(awk -v e="$1" 'BEGIN {print e / 20}')"
  shift
done
answers one table --theory vermeulen-johnson --ratio-from 2 --ratio-to 2 --ratios 4 --longitudinal 2 --lateral 2 --spin 3 --points 5
grep -q '"nodes": "1 axis ratios x 2 x 2 x 3 spins"' one.json || fail "one ratio"
# Kalker's table has 4.12 for a round contact and a ratio of Poisson's of 1/4; computed it is less by a sixth of a per cent.
for coefficients in table computed; do
  answers c11 table --theory linear --coefficients $coefficients --poisson 0.25 --ratio-from 1 --ratio-to 1 --longitudinal 2 --lateral 2 --spin 3 --points 3
  c11=$(awk -F, '$2 == 5 && $3 == 0 && $4 == 0 {print $5 / 5}' c11/table.csv)
  case $coefficients in table) near C11 "$c11" 4.12 1e-9 ;; *) near "C11 computed" "$c11" 4.113 0.002 ;; esac
done
for cells in 4 8; do answers full$cells table --ratios 2 --longitudinal 2 --lateral 2 --spin 3 --points 10 --cells $cells; done
grep -q '"coarse"' full4.json || fail "4 cells are not too coarse: $(v full4 theory_error_rms)"
grep -q '"range"' full4.json && fail "a warning about the full theory"
answers coarse curve --a 6mm --b 20mm --load 80kN --points 3 --cells 4 --spin 1rad/m
grep -q ',"the cells are too coarse: error estimate above 0.1 mu N' coarse/curve.csv || fail "rows of 4 cells are not too coarse"
awk -v l="$(v full8 theory_error_largest)" -v r="$(v full8 theory_error_rms)" -v m="$(v full8 theory_error_moment_rms)" 'BEGIN {exit !(r > 0 && r < l && m > 0)}' || fail "the theory's own error"
# What sticks is a share, of no sign, from all at rest to nothing in sliding.
for theory in full fastsim fastrip shen-hedrick-elkins polach vermeulen-johnson; do
  answers share curve --a 6mm --b 4mm --load 80kN --theory $theory --points 6
  holds "what sticks by $theory" share/curve.csv '$c["stick_share"] !~ /^[0-9]/ || $c["stick_share"] > 1 {print $c["stick_share"]; wrong++} rows == 1 {near($c["stick_share"], 1, 1e-9)} rows > 1 && $c["stick_share"] > last {wrong++} {last = $c["stick_share"]} END {near(last, 0, 0.1)}'
done
# The other way round, forces and moment change their signs, none of them is lost.
for theory in full fastsim; do
  answers way curve --a 6mm --b 4mm --load 80kN --theory $theory --points 5 --from -2e-3 --to 2e-3 --lateral 3e-4 --spin 0.4rad/m
  answers other curve --a 6mm --b 4mm --load 80kN --theory $theory --points 5 --from 2e-3 --to -2e-3 --lateral -3e-4 --spin -0.4rad/m
  paste -d, way/curve.csv other/curve.csv >both.csv
  holds "the other way by $theory" both.csv '{n = NF / 2; for (k = 1; k <= 6; ++k) {near($k, -$(k + n), 1e-6 * abs($k)); if (rows != 3 && k != 4 && $k == 0) {print "nothing in column " k; wrong++}} sum += $4 != 0} END {near(rows, 5, 0); near(sum >= 4, 1, 0)}'
done
