#!/bin/sh
# modes.sh BUILD TABLES DIGITS CHAPTER...: runs the chapters in the four modes of rounding, two at a time, and compares the numbers of
# their checks (see digits.cpp). With ACCEPT=1 the tables are written.
build=$1 tables=$2 digits=$3
shift 3
at=$build/ctest/digits
rm -rf "$at" && mkdir -p "$at" || exit 1
for chapter in "$@"; do
  for mode in nearest up down zero; do echo "${chapter#*-} $mode"; done
done | xargs -P 2 -L 1 sh -c '"$0/bin/$2" reproduce --no-figures --no-timings --rounding "$3" --out "$1" >"$1/$2-$3.log" 2>&1
  [ $? -le 1 ] || { cat "$1/$2-$3.log"; exit 255; }' "$build" "$at" || exit 1
"$digits" "$at" "$tables" ${ACCEPT:+--accept}
