#!/bin/sh
# reproduce.sh BUILD LEVEL CHAPTER...: runs the chapters, weaves the book, and sums up. Fails if any of them did,
# but runs them all.
set -u
build=$1 level=$2
shift 2
failed=0 count=0 total=$#
for chapter in "$@"; do
  count=$((count + 1))
  echo "[$count/$total] $chapter ..."
  "$build/bin/${chapter#*-}" reproduce --level "$level" --out "$build" || failed=1
done
echo "[book]"
cmake --build "$build" --target book || failed=1
echo
for chapter in "$@"; do cat "$build/results/$chapter.txt"; done
echo "book: $build/book/index.html"
[ "$failed" = 0 ] || echo "NOT all good: see the messages above."
exit "$failed"
