#!/bin/sh
# clean_profiles.sh RAILBOOK: random clean pairs of wheel and rail, of other cones, flanges, spacings and rounding: at most one in twenty has a warning.
railbook=$1
folder=$(mktemp -d) || exit 1
trap 'rm -rf "$folder"' EXIT
cd "$folder" || exit 1
# points SEED SPACING ROUND u0 h0 angle0 length,curvature,...: along arcs, from the outer end inwards, in mm; noise of half a micrometre.
points() {
  awk -v seed="$1" -v spacing="$2" -v quantum="$3" -v u="$4" -v h="$5" -v angle="$6" -v arcs="$7" 'BEGIN {
    srand(seed); n = split(arcs, a, ","); print "inward_mm,height_mm"; step = 0.001; next_at = s = 0
    for (k = 1; k < n; k += 2) for (t = 0; t < a[k]; t += step) {
      if (s >= next_at) {next_at += spacing; noise = 0; for (m = 0; m < 12; ++m) noise += rand(); noise = 5e-4 * (noise - 6)
        printf "%.6f,%.6f\n", u, quantum * int((h + noise) / quantum + (h + noise > 0 ? 0.5 : -0.5))}
      angle += step * a[k + 1]; u += step * cos(angle); h -= step * sin(angle); s += step}}'
}
warned=0 pairs=${2:-20}
for seed in $(seq "$pairs"); do
  # shellcheck disable=SC2046 # numbers
  set -- $(awk -v s="$seed" 'BEGIN {srand(s * 7919); rand(); print 1 / (20 + 30 * rand()), 0.25 + 1.25 * rand(), 11 + 5 * rand(), 250 + 100 * rand(), rand() < 0.5 ? 0.001 : 0.0001}')
  points "$seed" "$2" "$5" -55 "$(awk -v c="$1" 'BEGIN {print 55 * c}')" "$1" "$(awk -v c="$1" -v r="$3" 'BEGIN {
    printf "%g,0,%g,%g,9,0,20,-0.1", 78, r * (1.2217 - c), 1 / r}')" >wheel.csv
  points "$((seed + 500))" "$2" "$5" -36 -13 -1.45 "$(awk -v r="$4" 'BEGIN {
    printf "15.86,%g,15.76,%g,%g,%g,15.76,%g,15.86,%g,6,0", 1 / 13, 1 / 80, 0.066 * r, 1 / r, 1 / 80, 1 / 13}')" >rail.csv
  for command in "hunting geometry --end 4mm --step 0.1mm" "wheelrail contact --load 60kN --speed 20m/s --method strips"; do
    # shellcheck disable=SC2086 # words
    "$railbook" $command --wheel wheel.csv --rail rail.csv >said 2>&1 || { echo "pair $seed, $command: $(cat said)"; exit 1; }
    if grep WARNING said >warning; then echo "pair $seed, $command: $(cat warning)"; warned=$((warned + 1)); fi
  done
done
echo "$warned of $((2 * pairs)) answers of clean profiles have a warning"
[ "$warned" -le $((2 * pairs / 20)) ]
