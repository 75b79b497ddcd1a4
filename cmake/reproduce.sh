#!/bin/sh
# reproduce.sh BUILD LEVEL JOBS CHAPTER...: runs the chapters that something has changed for, weaves the book, and sums up.
# Fails if any of them did, but runs them all. All chapters are begun at once and take turns: JOBS of them work, and who
# measures time waits until the others have no work (lib/report/turn.hpp). What a chapter was run with and what it left
# stands in BUILD/results/NN-name.stamp.
#   reproduce.sh --copy BUILD LEVEL CHAPTER TO    what such a run has left, if nothing has changed since; status 1 otherwise
set -u
# A chapter's own process: the program, what it reads, and what it writes.
inputs() { echo "$level"; find "chapters/$1" lib -type f ! -name '*.?pp' ! -name CMakeLists.txt | LC_ALL=C sort | xargs cat "$build/bin/${1#*-}"; }
files() { echo "results/$1 results/$1.json results/$1.txt results/$1.files figures/$1"; }
outputs() { (cd "$build" && find $(files "$1") -printf '%p %s %T@\n' 2> /dev/null) | LC_ALL=C sort; }
stamp() { inputs "$1" | sha256sum; outputs "$1" | sha256sum; }
stands() { [ -f "$build/results/$1.stamp" ] && stamp "$1" | cmp -s - "$build/results/$1.stamp"; }
if [ "$1" = --copy ]; then
  build=$2 level=$3 chapter=$4 to=$5
  stands "$chapter" || exit 1
  for file in $(files "$chapter"); do
    mkdir -p "$to/${file%/*}" && rm -rf "${to:?}/$file" && cp -R "$build/$file" "$to/$file" || exit
  done
  exit 0
fi
if [ "$1" = --chapter ]; then
  build=$2 level=$3 chapter=$4
  rm -f "$build/results/$chapter.stamp"
  if "$build/bin/${chapter#*-}" reproduce --level "$level" --out "$build" --progress; then
    stamp "$chapter" > "$build/results/$chapter.stamp"
    echo "chapter $chapter:$(sed 's/.*;//' "$build/results/$chapter.txt")"
  else
    echo "chapter $chapter: NOT good"
  fi
  exit 0
fi

build=$1 level=$2 jobs=$3
shift 3
mkdir -p "$build/results" "$build/turns"
rm -f "$build"/turns/place-*
for place in $(seq "$jobs"); do : > "$build/turns/place-$place"; done
RAILBOOK_TURNS=$(cd "$build/turns" && pwd)
export RAILBOOK_TURNS
due=
for chapter in "$@"; do
  stands "$chapter" || due="$due $chapter"
done
if [ -n "$due" ]; then
  chapters=$(echo "$due" | wc -w) items=$(for chapter in $due; do "$build/bin/${chapter#*-}" list; done | wc -l)
  [ "$chapters" = $# ] || echo "Nothing has changed for the other chapters."
  echo "Running$due, $jobs at a time: $items tables and figures ..."
  began=$(date +%s) said=$(date +%s) n=0 k=0
  echo "$due" | xargs -n 1 -P "$chapters" "$0" --chapter "$build" "$level" | while read -r what rest; do
    case $what in
    item)
      n=$((n + 1)) now=$(date +%s)
      [ $((now - said)) -lt 5 ] || { said=$now && echo "$n of $items, about $(((now - began) * (items - n) / n)) s left"; } ;;
    chapter) k=$((k + 1)) && echo "[$k/$chapters] $rest" ;;
    esac
  done
fi
failed=0
for chapter in "$@"; do [ -f "$build/results/$chapter.stamp" ] || failed=1; done

# The book is woven of all of this.
sources() { find chapters lib book docs README.md CMakeLists.txt "$build/results" "$build/figures" -type f ! -name book.stamp -printf '%p %s %T@\n' | LC_ALL=C sort | sha256sum; }
if [ ! -f "$build/book/index.html" ] || ! sources | cmp -s - "$build/results/book.stamp"; then
  echo "[book]"
  if cmake --build "$build" --target book; then sources > "$build/results/book.stamp"; else failed=1; fi
fi
echo
for chapter in "$@"; do cat "$build/results/$chapter.txt"; done
echo "book: $build/book/index.html"
[ "$failed" = 0 ] || echo "NOT all good: see the messages above."
exit "$failed"
