#!/usr/bin/env bash
# en-15302.sh RAILBOOK: the standard's two numbers are those of the level axle's list; a cone of 1:20 has 0.05 and is linear.
set -euo pipefail
examples=$(cd "$(dirname "$0")/../../tools/examples/hunting" && pwd)
work=$(mktemp -d)
trap 'rm -r "$work"' EXIT
cd "$work"
value() { sed -n "s/^  \"$2\": \(-\?[0-9.e+-]*\),\?\$/\1/p" "$1" | head -1; }
near() { awk -v a="$1" -v b="$2" -v w="$3" 'BEGIN {exit !(a != "" && b != "" && a - b <= w && b - a <= w)}' || { echo "$4: $1 is not $2"; exit 1; }; }
place=(--end 8mm --step 0.05mm)
worn=(--wheel "$examples/worn-wheel.csv" --rail "$examples/new-rail.csv")
"$1" hunting geometry "${worn[@]}" "${place[@]}" --level --json > level
"$1" hunting geometry "${worn[@]}" "${place[@]}" --standard en-15302 --json > standard
near "$(value standard en_15302_conicity)" "$(value level conicity_at_3_mm)" 1e-12 "conicity at 3 mm"
near "$(value standard en_15302_nonlinearity_per_mm)" "$(awk -v a="$(value level conicity_at_4_mm)" -v b="$(value level conicity_at_2_mm)" 'BEGIN {print (a - b) / 2}')" 1e-6 nonlinearity
awk 'BEGIN {for (u = -60; u <= 47; u += 0.5) printf "%.3f %.6f\n", -u, -0.05 * u - (u > 40 ? (u - 40) ^ 2 / 2 : 0)}' > cone.txt
awk 'BEGIN {for (u = -36; u <= 36; u += 0.5) {a = u < 0 ? -u : u; printf "%.3f %.6f\n", u, -u * u / 600 - (a > 33 ? 3 * (a - 33) ^ 2 : 0)}}' > head.txt
"$1" hunting geometry --wheel cone.txt --rail head.txt --noise 0mm --cant 0 --gauge 1435mm --gauge-depth 14mm --radius 460mm \
  --half-spacing 750mm --end 5mm --step 0.05mm --standard en-15302 --json > cone
near "$(value cone en_15302_conicity)" 0.05 2e-4 "a cone"
near "$(value cone en_15302_nonlinearity_per_mm)" 0 1e-4 "a cone's nonlinearity"
