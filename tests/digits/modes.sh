#!/bin/sh
# modes.sh BUILD TABLES DIGITS CHAPTER...: runs the chapters in the four modes of rounding and with the mathematics of a processor without
# fused multiply-add, two at a time, and compares the numbers of their checks (see digits.cpp). RUNS are folders of further runs, such
# as those of tests/matrix.sh by other compilers. With ACCEPT=1 the tables are written.
build=$1 tables=$2 digits=$3
shift 3
at=$build/ctest/digits
rm -rf "$at" && mkdir -p "$at/other-maths" || exit 1
for run in $RUNS; do
  for chapter in "$@"; do
    [ -f "$run/results/$chapter.json" ] || { echo "$run has no record of $chapter"; exit 1; }
  done
  ln -s "$(realpath "$run")" "$at/$(echo "$run" | tr / _)" || exit 1
done
for chapter in "$@"; do
  for mode in nearest up down zero; do echo "${chapter#*-} $mode $at ''"; done
  echo "${chapter#*-} nearest $at/other-maths glibc.cpu.hwcaps=-FMA,-AVX2,-AVX512F,-FMA4"
done | xargs -P 2 -L 1 sh -c 'GLIBC_TUNABLES=$4 "$0/bin/$1" reproduce --no-figures --no-timings --rounding "$2" --out "$3" >"$3/$1-$2.log" 2>&1
  [ $? -le 1 ] || { cat "$3/$1-$2.log"; exit 255; }' "$build" || exit 1
"$digits" "$at" "$tables" ${ACCEPT:+--accept}
