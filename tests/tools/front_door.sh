#!/bin/bash
# front_door.sh REPRODUCE.SH: what is run and woven again, with chapters and a cmake that only leave their mark.
script=$1
folder=$(mktemp -d) || exit 77
trap 'rm -rf "$folder"' EXIT
cd "$folder" || exit 77
mkdir -p build/bin lib chapters/01-one chapters/02-two book docs bin
echo '# prose' | tee README.md CMakeLists.txt chapters/01-one/fig.gp chapters/02-two/fig.gp >book/page.lua
for name in one two; do
  cat >"build/bin/$name" <<'END'
#!/bin/sh
name=${0##*/}
[ "$1" = list ] && echo "a" && echo "b" && exit
for chapter in chapters/*-"$name"; do chapter=${chapter#chapters/}; done
echo "$name" >>ran
[ -f "$RAILBOOK_TURNS/place-2" ] && [ ! -f "$RAILBOOK_TURNS/place-3" ] || exit 1
echo "item a" && echo "item b" && echo "$name: checks 1/1; 1.5 s"
rm -f "build/results/$chapter.json"
mkdir -p "build/results/$chapter" "build/figures/$chapter"
[ ! -f "fail-$name" ] || exit 1
for file in "$chapter/a.csv" "$chapter.json" "$chapter.txt" "$chapter.files"; do echo "$name: checks 1/1; 1.5 s" >"build/results/$file"; done
END
done
cat >bin/cmake <<'END'
#!/bin/sh
echo book >>ran
mkdir -p build/book && echo book >build/book/index.html
END
chmod +x build/bin/* bin/cmake
export PATH=$folder/bin:$PATH
runs() { # runs STATUS "what ran, in the alphabet": reproduces, and compares
  : >ran
  "$script" build "${level:-quick}" 2 01-one 02-two >said 2>&1
  local status=$? ran
  ran=$(sort ran | tr '\n' ' ')
  [ "$status" = "$1" ] && [ "${ran% }" = "$2" ] && return
  echo "BAD: $3: status $status, ran $ran"
  cat said
  exit 1
}
runs 0 "book one two" "the first time"
grep -q ' 2 at a time: 4 tables and figures' said || { echo "BAD: does not say how much there is to do" && exit 1; }
grep -qx '\[2/2\] 0[12]-[a-z]*: 1.5 s' said || { echo "BAD: does not say what is done" && exit 1; }
touch build/turns/place-3 # of a run with more of them
runs 0 "" "the second time"
echo '# more' >>chapters/01-one/fig.gp
runs 0 "book one" "after a script of one chapter has changed"
echo '# more' >>build/bin/two
runs 0 "book two" "after a program has changed"
echo 1 >chapters/01-one/main.cpp
runs 0 "book" "after what the page shows of the source has changed"
rm build/results/02-two/a.csv
runs 0 "book two" "after a result is gone"
level=full runs 0 "book one two" "at another level"
level=full runs 0 "" "at that level again"
copied() { # copied STATUS LEVEL: what is left of chapter 01
  rm -rf copy
  "$script" --copy build "$2" 01-one copy
  [ $? = "$1" ] && { [ "$1" = 1 ] || diff -r build/results/01-one copy/results/01-one; } && return
  echo "BAD: --copy at level $2: not status $1, or other files" && exit 1
}
copied 0 full
copied 1 quick
echo 1 >>build/results/01-one.json
copied 1 full
level=full runs 0 "book one" "after a record has been touched"
copied 0 full
[ -d copy/figures/01-one ] && [ -f copy/results/01-one.txt ] || { echo "BAD: --copy leaves something out" && exit 1; }
touch fail-one && echo '# broken' >>build/bin/one
level=full runs 1 "book one" "when a chapter fails"
level=full runs 1 "one" "when it fails again"
copied 1 full
grep -q 'NOT all good' said || { echo "BAD: a failure is not said" && exit 1; }
rm fail-one
level=full runs 0 "book one" "after it is mended"
