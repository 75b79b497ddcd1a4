#!/usr/bin/env bash
# tests/coverage.sh [ROOM...]: lines and branches of lib/ and tools/ that the test programs of lib/ (all, or of the rooms named)
# take, by folder, from gcov; build/coverage/branches.txt lists the branches of the numerics that none takes. A build of its
# own, in build/coverage: a branch is counted where a person wrote it, so without optimization and without exceptions' edges.
set -euo pipefail
cd "$(dirname "$0")/.."
build=$PWD/build/coverage
cmake --preset default -B "$build" --log-level=WARNING -DCMAKE_BUILD_TYPE=Debug -DCMAKE_UNITY_BUILD=OFF -DRAILBOOK_PCH=OFF -DRAILBOOK_BOOK=OFF \
  -DCMAKE_CXX_FLAGS="--coverage -O0 -g1" > /dev/null
rooms=("$@")
(($# > 0)) || mapfile -t rooms < <(cd lib && ls -d -- */ | tr -d /)
programs=()
for room in "${rooms[@]}"; do
  ! compgen -G "tests/lib/$room/*.cpp" > /dev/null || programs+=("test_$room")
done
cmake --build "$build" --target "${programs[@]}"
find "$build" -name '*.gcda' -delete
for program in "${programs[@]}"; do
  "$build/lib/${program#test_}/$program" > "$build/$program.log" ||
    echo "$program does not pass so instrumented, what it ran is counted: $(tail -n 3 "$build/$program.log" | tr -s '\n' ' ')"
done
rm -rf "$build/gcov"
mkdir -p "$build/gcov"
cd "$build/gcov"
find "$build" -path "*/lib/*" -name '*.gcda' -exec gcov --branch-probabilities --source-prefix "$OLDPWD" --relative-only \
  --preserve-paths --hash-filenames {} + > /dev/null 2>&1
# One source may come from several programs: a line or a branch is taken when any took it.
cat -- *.gcov | awk -v list="$build/branches.txt" '
  /^ +-: +0:Source:/ { sub(/.*Source:/, ""); file = $0; next }
  file !~ /^(lib|tools)\// { next }
  /^branch/ { name = file ":" line; n[name]++; key = name ":" $2
              if (!/\(throw\)/) { seen[key] = file; if ($4 ~ /[1-9]/) took[key] = 1 } next }
  /^(call|function|unconditional)/ { next }
  { split($0, part, ":"); count = part[1]; line = part[2] + 0; gsub(/ /, "", count)
    if (line == 0 || count == "-") next
    text[file ":" line] = substr($0, index($0, part[3])); lines[file ":" line] = file
    if (count !~ /^[#=]/) ran[file ":" line] = 1 }
  END {
    for (k in lines) { split(lines[k], p, "/"); room = p[1] "/" p[2]; all[room]++; if (k in ran) good[room]++ }
    for (k in seen) { split(seen[k], p, "/"); room = p[1] "/" p[2]; branches[room]++
      if (k in took) taken[room]++
      else if (room ~ /^lib\/(num|contact|rolling|profiles|wheelset|wheel_contact|vehicle|cycles|records|spectra|filters|geometry_car|track|quality)$/) {
        at = k; sub(/:[0-9]+$/, "", at); print at ": " text[at] | "sort -u -t: -k1,1 -k2,2n > " list } }
    printf "%-22s %16s %20s\n", "folder", "lines run", "branches taken"
    for (room in all) printf "%-22s %6d of %6d %8d of %6d (%2.0f %%)\n", room, good[room], all[room], taken[room], branches[room],
      branches[room] ? 100 * taken[room] / branches[room] : 100 | "sort"
  }'
echo "branches of the numerics not taken: $build/branches.txt"
