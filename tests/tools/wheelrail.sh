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
# With nothing to read there is no table.
printf 'x' >wheel.csv
table --wheel wheel.csv --out other >said 2>&1 && fail "a file of one letter is no profile"
[ -e other ] && fail "a refused table leaves a folder"
exit 0
