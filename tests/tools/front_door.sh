#!/bin/bash
# front_door.sh REPRODUCE.CMAKE: what the target `reproduce` runs and weaves again, with chapters that only leave their mark.
folder=$(mktemp -d) || exit 77
trap 'rm -rf "$folder"' EXIT
cd "$folder" || exit 77
mkdir -p bin lib/plot chapters/0{1-one,2-two}/data book docs tests
echo '# prose' | tee README.md lib/plot/look.gp chapters/01-one/data/a.csv chapters/02-two/fig.gp >book/page.lua
for name in one two; do
  cat >"bin/$name" <<'END'
#!/bin/sh
name=${0##*/} && cd "$5" || exit
echo "$name" >>ran
for chapter in ../chapters/*-"$name"; do chapter=${chapter##*/}; done
rm -f "results/$chapter.json"
[ ! -f "fail-$name" ] || exit 1
mkdir -p results && echo "$*" >"results/$chapter.json"
END
done
chmod +x bin/*
cat >CMakeLists.txt <<END
cmake_minimum_required(VERSION 3.25)
project(door LANGUAGES NONE)
add_custom_target(chapter_programs)
include($1)
add_subdirectory(chapters/01-one)
add_subdirectory(chapters/02-two)
railbook_reproduce_book(sh -c "echo book >> ran")
END
for chapter in 01-one 02-two; do
  name=${chapter#*-}
  printf 'add_executable(%s IMPORTED GLOBAL)\nset_target_properties(%s PROPERTIES IMPORTED_LOCATION %s)\nrailbook_reproduce(%s %s)\n' \
    "$name" "$name" "$folder/bin/$name" "$chapter" "$name" >"chapters/$chapter/CMakeLists.txt"
done
runs() { # runs STATUS "what ran, in the alphabet" WHEN
  : >build/ran
  cmake -G Ninja -DRAILBOOK_LEVEL="${level:-quick}" -B build >output 2>&1 && (cd build && ninja -k 0 reproduce) >>output 2>&1
  local status=$? ran
  ran=$(sort build/ran | tr '\n' ' ')
  [ "$((status != 0))" = "$1" ] && [ "${ran% }" = "$2" ] && return
  echo "BAD: $3: status $status, ran $ran"
  cat output
  exit 1
}
mkdir -p build/bin && cp bin/* build/bin
runs 0 "book one two" "the first time"
runs 0 "" "the second time"
sleep 0.01 && echo '# more' >>chapters/02-two/fig.gp
runs 0 "book two" "after a script of one chapter has changed"
echo 1 >chapters/01-one/data/b.csv
runs 0 "book one" "after data of one chapter have come"
echo '# more' >>lib/plot/look.gp
runs 0 "book one two" "after the look of all figures has changed"
touch bin/one
runs 0 "" "after a program was linked again to the same"
echo '# more' >>bin/two
runs 0 "book two" "after a program has changed"
echo '# more' >>book/page.lua
runs 0 "book" "after what only the book is made of has changed"
rm build/results/02-two.json
runs 0 "book two" "after a record is gone"
level=full runs 0 "book one two" "at another level"
grep -q -- '--level full --out' build/results/01-one.json || { echo "BAD: not at that level" && exit 1; }
level=full runs 0 "" "at that level again"
touch build/fail-one && echo '# broken' >>bin/one
level=full runs 1 "one" "when a chapter fails"
level=full runs 1 "one" "when it fails again"
rm build/fail-one
level=full runs 0 "book one" "after it is mended"
