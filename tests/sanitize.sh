#!/usr/bin/env bash
# tests/sanitize.sh: the test programs of lib/ and every chapter, quick and without figures, under the address and
# undefined-behaviour sanitizers with the assertions of the standard library and of Eigen, in build/sanitize.
set -euo pipefail
cd "$(dirname "$0")/.."
build=build/sanitize
jobs=${JOBS:-$(nproc)}
names=(chapters/*/)
names=("${names[@]%/}")
names=("${names[@]#chapters/??-}")
cmake --preset sanitize --log-level=WARNING > /dev/null
cmake --build "$build" --target unit_tests "${names[@]}" -j "$jobs"

one() { # a program and its arguments: silent when it passes
  local said
  said=$(mktemp)
  "$@" > "$said" 2>&1 || { echo "FAILS: $*"; tail -n 40 "$said"; rm "$said"; return 1; }
  rm "$said"
}
export -f one
for name in "${names[@]}"; do echo "$build/bin/$name reproduce --no-figures --no-timings --out $build/reproduced"; done |
  xargs -P "$jobs" -I {} bash -c 'one {}'
ctest --test-dir "$build" -L '^unit$' -j "$jobs" --output-on-failure > "$build/unit.log" || { tail -n 60 "$build/unit.log"; exit 1; }
echo "nothing found by the sanitizers in $(grep -c ' Passed ' "$build/unit.log") tests and ${#names[@]} chapters"
