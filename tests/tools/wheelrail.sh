#!/bin/sh
# wheelrail.sh RAILBOOK: a table by several processes and by shards is the same, and a rerun has nothing to do.
railbook=$1
folder=$(mktemp -d) || exit 1
trap 'rm -rf "$folder"' EXIT
cd "$folder" || exit 1
fail() { echo "$*"; exit 1; }
table() { "$railbook" wheelrail table --speed 30m/s --from 0mm --to 9mm --shifts 4 --yaws 2 --yaw-to 4mrad --load 30kN 50kN --slip -0.001 0.001 "$@"; }
table --out whole --jobs 2 >said || fail "$(cat said)"
grep -q "rows of the table *32$" said || fail "$(cat said)"
grep -q "^record,status,reason,shift_mm,yaw_mrad,load_kN" whole/wheelrail-table.csv || fail "columns: $(head -1 whole/wheelrail-table.csv)"
for column in interpolation_error_of_mu_N method_error_of_mu_N; do
  head -1 whole/wheelrail-table.csv | grep -q "$column" || fail "no $column"
done
for i in 1 2; do table --out parts --shard $i/2 >/dev/null || fail "shard $i"; done
table --out parts >said && grep -q "done in an earlier run *8" said || fail "merging: $(cat said)"
cmp whole/wheelrail-table.csv parts/wheelrail-table.csv || fail "shards make another table"
table --out whole --mu 0.2 >said && grep -q "done in an earlier run *0" said || fail "another friction: $(cat said)"
# Another profile under the same name is another table.
printf 'x' >wheel.csv
table --wheel wheel.csv --out other >said 2>&1 && fail "a file of one letter is no profile"
exit 0
