#!/usr/bin/env bash
# measure.sh RAILBOOK: gauges of wheels and rails from files, one and several.
set -euo pipefail
examples=$(cd "$(dirname "$0")/../../tools/examples/hunting" && pwd)
work=$(mktemp -d)
trap 'rm -r "$work"' EXIT
cd "$work"
railbook=$1
number() { sed -n "s/^ *\"$2\": \(-\?[0-9.e+-]*\),\?\$/\1/p" "$1" | head -1; }
near() { awk -v a="$1" -v b="$2" -v w="$3" 'BEGIN {exit !(a != "" && a - b <= w && b - a <= w)}' || { echo "$4: $1 is not $2"; exit 1; }; }
# A flange of straight lines: the face from 40 mm, 5 mm down, to 50 mm, 25 mm down; the tip at 55 mm is 30 mm deep.
wheel() { awk -v noise="$1" 'function z(u) {return u < 38 ? 0 : u < 40 ? -5 * (u - 38) / 2 : u < 50 ? -5 - 2 * (u - 40) : u < 60 ? -25 - 5 * (1 - ((u - 55) / 5) ^ 2) : -25 + (u - 60) * 3}
  BEGIN {srand(3); print "inward_mm,height_mm"; for (u = -60; u <= 66; u += 0.1) printf "%.4f,%.5f\n", u, z(u) + noise * (rand() - 0.5)}'; }
wheel 0 > w0.csv
wheel 0.01 > w1.csv
"$railbook" wheelrail measure w0.csv --body wheel --noise 0mm --json > one
near "$(number one flange_thickness_mm)" 27.5 2e-3 "Sd"
near "$(number one flange_height_mm)" 30 1e-3 "Sh"
near "$(awk -v q="$(number one flange_gradient_mm)" 'BEGIN {print q + 42.5}')" "$(awk 'BEGIN {print 55 - 5 * sqrt(0.4)}')" 5e-3 "qR"
# Of several a row each; the errors cover what noise does, and what is no wheel is refused.
printf 'inward_mm,height_mm\n1,2\n' > none.csv
! "$railbook" wheelrail measure w0.csv w1.csv none.csv --json > several
[ "$(wc -l < several)" -eq 3 ]
[ "$(grep -c '"status":"ok"' several)" -eq 2 ]
sed -n '1,2s/.*"flange_thickness_mm":\([0-9.]*\),"flange_thickness_error_mm":\([0-9.e-]*\).*/\1 \2/p' several |
  awk '{d = $1 - 27.5; if (d < 0) d = -d; if (d > $2 + 5e-3) exit 1; n++} END {exit n != 2}' || { echo "the errors do not cover the scatter"; exit 1; }
# A crown, and the wear against the rail that it was, 0.5 mm higher.
awk -F, 'NR > 1 && $1 + 0 == $1 {print $1 "," $2 - 0.5; next} {print}' "$examples/new-rail.csv" > lower.csv
"$railbook" wheelrail measure lower.csv --body rail --new-rail "$examples/new-rail.csv" --json > wear
near "$(number wear wear_vertical_mm)" 0.5 1e-3 "W1"
"$railbook" wheelrail measure "$examples/new-rail.csv" --body rail --new-rail lower.csv | grep -q 'WARNING: wear on the axis, W1 is negative'
