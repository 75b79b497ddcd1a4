#!/usr/bin/env bash
# two_sides.sh RAILBOOK: moving wheelset and rails together changes nothing; exchanging left and right exchanges their answers.
set -euo pipefail
examples=$(cd "$(dirname "$0")/../../tools/examples/hunting" && pwd)
work=$(mktemp -d)
trap 'rm -r "$work"' EXIT
cd "$work"
contact() { "$railbook" wheelrail contact --load 50kN --speed 30m/s --method strips --json "$@"; }
value() { sed -n "s/^  \"$2\": \(-\?[0-9.e+-]*\),\?\$/\1/p" "$1" | head -1; }
near() { awk -v a="$1" -v b="$2" -v w="$3" 'BEGIN {exit !(a != "" && b != "" && a - b <= w && b - a <= w)}' || { echo "$4: $1 is not $2"; exit 1; }; }
railbook=$1
contact > usual
contact --shift 2mm --left-rail-shift 2mm --right-rail-shift 2mm > moved
for side in left right; do
  near "$(value moved ${side}_y_N)" "$(value usual ${side}_y_N)" 0.01 "the force on the $side"
  near "$(value moved ${side}_1_y_mm)" "$(awk -v y="$(value usual ${side}_1_y_mm)" 'BEGIN {print y + 2}')" 1e-3 "the patch on the $side"
done
worn=$examples/worn-wheel.csv
contact --wheel "$worn" --rail "$examples/new-rail.csv" --right-radius 459.5mm --right-cant 1:30 --cant 1:40 --right-rail-lift 0.3mm > one
contact --wheel "$worn" --rail "$examples/new-rail.csv" --radius 459.5mm --right-radius 460mm --right-cant 1:40 --cant 1:30 --left-rail-lift 0.3mm > other
near "$(value one roll_mrad)" "$(awk -v y="$(value other roll_mrad)" 'BEGIN {print -y}')" 1e-5 "the roll of the sides exchanged"
for key in x_N z_N 1_p_max_MPa 1_normal_N; do
  near "$(value one left_$key)" "$(value other right_$key)" "$(awk -v y="$(value other right_$key)" 'BEGIN {print 1e-4 * (y < 0 ? -y : y)}')" "$key of the left wheel on the right"
done
awk -v a="$(value one left_1_p_max_MPa)" -v b="$(value one right_1_p_max_MPa)" 'BEGIN {exit !(a > b * 1.001 || b > a * 1.001)}' || { echo "unlike sides have one pressure"; exit 1; }
