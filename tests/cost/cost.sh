#!/usr/bin/env bash
# cost.sh RAILBOOK EXAMPLES COSTS.csv compare|accept: counts the instructions of the works in works.txt with valgrind (and notes the pairs of
# Fourier transforms of those that say them), and compares them with
# those that COSTS.csv has, or writes it. A work that has become dearer by more than 1 % is a fault (status 1); a cheaper one is not.
# Without valgrind, or on another machine than that of COSTS.csv (its second line: processor, C library, compiler), nothing is
# compared (status 77).
set -euo pipefail
railbook=$1 examples=$2 costs=$3 verb=$4
here=$(cd "$(dirname "$0")" && pwd)
command -v valgrind > /dev/null || { echo "no valgrind: not counted" && exit 77; }
tuning="$(uname -m) $(grep -o -m 1 -w avx2 /proc/cpuinfo || true), $(ldd --version | sed -n '1s/.*) //;1p'), GCC $(strings -a "$railbook" | sed -n 's/^GCC: (.*) //p' | head -n 1)"
if [ "$verb" = compare ] && [ "$(sed -n '2s/^# //p' "$costs")" != "$tuning" ]; then
  echo "counted on $(sed -n '2s/^# //p' "$costs"), here is $tuning: not compared"
  exit 77
fi
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
"$railbook" psd synthesize "$work/record.csv" --length 20km --roughness "5e-7m^2*cycle/m" --corner 0.13cycle/m --dip 11mm > /dev/null
status=0
{
  echo "# Instructions of ten works, counted by valgrind; made by \`make accept-cost\`, compared by \`make cost\`."
  echo "# $tuning"
  echo "key,work,million_instructions,transform_pairs"
} > "$work/costs.csv"
printf '%-14s %12s %12s %7s\n' work "million now" before ratio
while IFS='|' read -r key what words; do
  [[ $key = \#* || -z $key ]] && continue
  key=${key// /} what=$(sed 's/^ *//;s/ *$//' <<< "$what")
  words=${words//RECORD/$work/record.csv}
  read -ra words <<< "${words//EXAMPLES/$examples}"
  GLIBC_TUNABLES=glibc.malloc.arena_max=1 valgrind --tool=cachegrind --cache-sim=no --cachegrind-out-file="$work/out" --log-file="$work/log" \
    "$railbook" "${words[@]}" > "$work/answer" || { cat "$work/log" "$work/answer" && exit 1; }
  now=$(sed -n 's/^==.*I *refs: *//p' "$work/log" | tr -d ,)
  now=$(awk "BEGIN {printf \"%.1f\", $now / 1e6}")
  pairs=$(sed -n 's/^.*pairs of Fourier transforms[^0-9]*\([0-9.]*\).*/\1/p' "$work/answer")
  echo "$key,$what,$now,$pairs" >> "$work/costs.csv"
  before=$(sed -n "s/^$key,.*,\([0-9.]*\),[0-9.]*$/\1/p" "$costs" 2> /dev/null || true)
  awk -v k="$key" -v n="$now" -v b="${before:-0}" 'BEGIN {
    printf("%-14s %12.1f %12.1f %7s\n", k, n, b, (b > 0 ? sprintf("%.3f", n / b) : "new"))
    exit(b > 0 && n > 1.01 * b) }' || status=1
done < "$here/works.txt"
if [ "$verb" = accept ]; then
  cp "$work/costs.csv" "$costs"
elif ((status)); then
  echo "dearer by more than 1 %: make it cheaper, or say why in the commit and \`make accept-cost\`"
  exit 1
fi
