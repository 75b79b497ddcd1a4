#!/bin/sh
# wheelrail.sh RAILBOOK: a table made in parts, one for each yaw, has the same rows.
railbook=$1
folder=$(mktemp -d) || exit 1
trap 'rm -rf "$folder"' EXIT
cd "$folder" || exit 1
fail() { echo "$*"; exit 1; }
table() { "$railbook" wheelrail table --speed 30m/s --from 0mm --to 9mm --shifts 4 --load 30kN 50kN --slip -0.001 0.001 "$@"; }
table --yaws 2 --yaw-to 4mrad --out whole >said || fail "$(cat said)"
grep -q "rows of the table *32$" said || fail "$(cat said)"
grep -q "^record,status,reason,shift_mm,yaw_mrad,load_kN" whole/wheelrail-table.csv || fail "columns: $(head -1 whole/wheelrail-table.csv)"
for column in interpolation_error_of_mu_N method_error_of_mu_N; do
  head -1 whole/wheelrail-table.csv | grep -q "$column" || fail "no $column"
done
for yaw in 0 4; do
  table --yaw-from ${yaw}mrad --yaw-to ${yaw}mrad --json >yaw$yaw.jsonl || fail "yaw $yaw"
  grep "yaw $yaw mrad" whole/wheelrail-table.jsonl | cmp - yaw$yaw.jsonl || fail "a part has other rows"
done
# Two patches are two rows, which bear the wheel's forces together.
"$railbook" wheelrail table --speed 30m/s --from 5.5mm --to 5.5mm --shifts 1 --load 50kN --cant 0.05 --out two >said || fail "$(cat said)"
awk -F, 'NR == 1 {for (i = 1; i <= NF; ++i) at[$i] = i + 1; next}
  {a = $at["angle_mrad"] / 1e3; x += $at["fx_N"]; y += $at["fy_N"] * cos(a) - $at["normal_N"] * sin(a); z += $at["normal_N"] * cos(a) + $at["fy_N"] * sin(a); w += $at["patch_wear_N"]}
  NR == 2 {fx = $at["x_N"]; fy = $at["y_N"]; fz = $at["z_N"]; wear = $at["wear_N"]; patches = $at["patches"]}
  function near(u, v) {return u - v < 0.01 && v - u < 0.01}
  END {exit !(NR == 3 && patches == 2 && near(x, fx) && near(y, fy) && near(z, fz) && near(w, wear))}' two/wheelrail-table.csv || fail "two patches: $(cat two/wheelrail-table.csv)"
# The error stated for a step covers what sixteen times as many shifts show, where a patch grows into another near one end of it.
steps() { "$railbook" wheelrail table --speed 10m/s --load 50kN --slip 0.001 --from 0mm --to 0.5mm --shifts "$1" --out "steps$1" >said || fail "$(cat said)"; }
steps 2
steps 17
cat steps2/wheelrail-table.csv steps17/wheelrail-table.csv | awk -F, '
  /^record/ { ++part; for (i = 1; i <= NF; ++i) at[$i] = i + 1; next }  # the name has a comma
  part == 1 && !(stated > 0) { stated = $at["interpolation_error_of_mu_N"] }
  part == 2 && $at["patch"] == 1 { x[n + 0] = $at["x_N"]; y[n++ + 0] = $at["y_N"] }
  END {
    if (n != 17) { print n " rows"; exit 1 }
    for (i = 0; i < n; ++i) {
      dx = x[i] - x[0] - i / 16 * (x[16] - x[0]); dy = y[i] - y[0] - i / 16 * (y[16] - y[0])
      if (sqrt(dx * dx + dy * dy) / 15000 > largest) largest = sqrt(dx * dx + dy * dy) / 15000
    }
    if (!(stated > 0.9 * largest && stated <= 1.001 * largest)) { print "stated " stated ", largest " largest; exit 1 }
  }' || fail "the error of interpolation does not hold"
grep -q "[,;]method" steps2/wheelrail-table.csv || fail "strips 27 % off the full theory have no flag"
# A wheel file that ends before its flange is answered, with a warning in Nadal's limit's place.
awk -F, '/^[#i]/ || $1 < 10' "${0%/*}/../../tools/examples/hunting/worn-wheel.csv" >tread.csv
"$railbook" wheelrail contact --wheel tread.csv --load 50kN --speed 20m/s --roll 0rad --slip 0 --method strips >said || fail "$(cat said)"
grep -q "WARNING: the wheel has no flange, its steepest place rises by [0-9.]* degrees: is the profile whole?" said || fail "no flange: $(cat said)"
grep -q "Nadal" said && fail "a limit of a flange that is not there"
# With nothing to read there is no table.
printf 'x' >wheel.csv
table --wheel wheel.csv --out other >said 2>&1 && fail "a file of one letter is no profile"
[ -e other ] && fail "a refused table leaves a folder"
exit 0
