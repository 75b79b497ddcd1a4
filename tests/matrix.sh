#!/usr/bin/env bash
# tests/matrix.sh [CHAPTER...]: do the chapters say the same whatever compiles them and wherever they run? Each of GCC and Clang at
# -O0, -O2 and -O3 builds them in build/matrix; each build runs them with the processor's mathematics and with that of one without fused
# multiply-add, on one core and on all. Every check must pass, and every value and sentence be the same text (same_text) as
# those of GCC at -O2, what readers have. An hour and a half of one core for all chapters; `tests/matrix.sh 05-psd` takes one. With
# ACCEPT=1 the digits that all these runs and the modes of rounding have in common are written into tests/digits.
set -uo pipefail
cd "$(dirname "$0")/.."
build=$PWD/build/matrix
chapters=("$@")
(($# > 0)) || mapfile -t chapters < <(cd chapters && ls -d -- [0-9]*/ | tr -d /)
other_maths=glibc.cpu.hwcaps=-FMA,-AVX2,-AVX512F,-FMA4
failed=0
reference=
for level in -O2 -O3 -O0; do # the longest last
  for compiler in g++ clang++-14; do
    command -v "$compiler" > /dev/null || { echo "$compiler is not installed: left out"; continue; }
    here=$build/$compiler$level
    cmake --preset default -B "$here" --log-level=WARNING -DCMAKE_CXX_COMPILER="$compiler" -DRAILBOOK_PCH=OFF -DRAILBOOK_BOOK=OFF \
      -DCMAKE_CXX_FLAGS_RELEASE="$level -DNDEBUG" > /dev/null || exit 1
    cmake --build "$here" --target "${chapters[@]#*-}" same_text || exit 1
    for maths in own other; do
      for cores in all one; do
        # All four at -O2; at the others the two ends.
        [[ $level == -O2 || $maths$cores == ownall || $maths$cores == otherone ]] || continue
        run=$here/run-$maths-$cores
        for chapter in "${chapters[@]}"; do
          settings=()
          [[ $maths == own ]] || settings+=(GLIBC_TUNABLES=$other_maths)
          pin=()
          [[ $cores == all ]] || pin=(taskset -c 0)
          record=$run/results/$chapter.json
          if ! env "${settings[@]}" "${pin[@]}" "$here/bin/${chapter#*-}" reproduce --no-figures --no-timings --out "$run" > "$here/run.txt" 2>&1; then
            echo "FAILED: $chapter, $compiler $level, $maths maths, $cores: $(tail -n 1 "$here/run.txt")" && failed=1
          fi
          [[ -n $reference ]] || reference=$run
          "$here/tests/figures/same_text" "$reference/results/$chapter.json" "$record" > "$here/run.txt" 2>&1 ||
            { echo "OTHER TEXT: $chapter, $compiler $level, $maths maths, $cores" && head -n 5 "$here/run.txt" && failed=1; }
        done
        echo "$compiler $level, $maths maths, cores: $cores: run"
      done
    done
  done
done
if [[ -n ${ACCEPT:-} ]]; then
  cmake --build build --target digits "${chapters[@]#*-}" || exit 1
  RUNS=$(echo "$build"/*/run-*) tests/digits/modes.sh "$PWD/build" tests/digits "$(find build -name digits -type f -perm -u+x)" "${chapters[@]}" || failed=1
fi
((failed == 0)) && echo "all checks pass, and all text is the same"
exit "$failed"
