#!/usr/bin/env bash
# pairs.sh RAILBOOK: several wheels on several rails are answered in rows that say what each pair's own answer says.
set -euo pipefail
examples=$(cd "$(dirname "$0")/../../tools/examples/hunting" && pwd)
work=$(mktemp -d)
trap 'rm -r "$work"' EXIT
cp "$examples"/{new,worn}-{wheel,rail}.csv "$work"
cd "$work"
railbook=$1
printf 'inward_mm,height_mm\n1,2\n' > broken.csv
for command in "hunting geometry --end 8mm --step 0.1mm" "wheelrail contact --gauge 56.5in --gauge-depth 0.625in --radius 16.5in --load 50kN --speed 10m/s --method strips --roll 0rad --slip 0"; do
  $railbook $command --wheel new-wheel.csv worn-wheel.csv --rail new-rail.csv worn-rail.csv --out all > said
  table=$(echo all/*-table.csv)
  [ "$(wc -l < "$table")" -eq 5 ]
  $railbook $command --wheel worn-wheel.csv --rail new-rail.csv --json > one
  awk -F'\t' 'NR == FNR {if (/^ "values"/) on = 1; else if (/^ }/) on = 0; else if (on && match($0, /^  "[^"]*": -?[0-9]/)) {split($0, part, "\""); v = $0; sub(/^[^:]*: /, "", v); sub(/,$/, "", v); want[part[2]] = v}; next}
    {for (k in want) {if (!match($0, "\"" k "\":-?[0-9.e+-]*")) {print k " is missing"; exit 1} found = substr($0, RSTART + length(k) + 3, RLENGTH - length(k) - 3); if (found + 0 != want[k] + 0) {print k, found, want[k]; exit 1} ++n}}
    END {exit n < 10}' one <(grep '"record":"worn-wheel.csv on new-rail.csv"' all/*.jsonl) || { echo "$command: another answer in the table"; exit 1; }
  # One that cannot be read is a row with its reason, and the others are answered.
  status=0
  $railbook $command --wheel broken.csv new-wheel.csv --rail new-rail.csv --json > rows 2> why || status=$?
  [ "$status" -eq 2 ] && [ "$(grep -c '"status":"ok"' rows)" -eq 1 ] && grep -q '"status":"refused","reason":"file .*broken.csv' rows || { echo "$command: $(cat why)"; exit 1; }
  rm -r all
done
