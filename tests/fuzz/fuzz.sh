#!/usr/bin/env bash
# tests/fuzz/fuzz.sh [SECONDS]: libFuzzer with both sanitizers on every parser, from the corpus; then a thousand random command
# lines. What it finds it leaves in build/fuzz; put the file into tests/fuzz/corpus once it is mended, and ctest keeps it.
set -euo pipefail
cd "$(dirname "$0")/../.."
clang=$(command -v clang++ clang++-14 clang++-19 | head -n 1) || { echo "clang++ is not installed"; exit 2; }
mkdir -p build/fuzz/found
flags=(-std=c++20 -O1 -g -fsanitize=fuzzer,address,undefined -fno-sanitize-recover=all -D_GLIBCXX_ASSERTIONS
  -ffp-exception-behavior=maytrap -Ibuild/include -Itests -Itools -isystem /usr/include/eigen3)
"$clang" "${flags[@]}" tests/fuzz/parsers.cpp lib/units/*.cpp lib/files/*.cpp lib/table/*.cpp lib/tool/toml.cpp \
  lib/profiles/{field_profile,miniprof,simpack,vampire,plain_profile,profile_points}.cpp \
  tools/quality/limits_file.cpp lib/{quality,filters,records,spectra,num}/*.cpp \
  -lfmt -lz -lgsl -lgslcblas -lfftw3_threads -lfftw3 -o build/fuzz/parsers
build/fuzz/parsers -max_total_time="${1:-60}" -timeout=10 -rss_limit_mb=4096 -max_len=4096 -print_final_stats=1 \
  -artifact_prefix=build/fuzz/ build/fuzz/found tests/fuzz/corpus
# What reads HDF5 and MAT files, in one process with the libraries: a fault may be theirs, which the command outlives.
if pkg-config --exists hdf5 matio; then
  # shellcheck disable=SC2046 # options
  "$clang" "${flags[@]}" -DH5_USE_110_API $(pkg-config --cflags hdf5 matio) tests/fuzz/containers.cpp lib/containers/{container,hdf5,mat}.cpp \
    lib/units/*.cpp lib/files/*.cpp lib/table/*.cpp $(pkg-config --libs hdf5 matio) -lfmt -lz -o build/fuzz/containers
  mkdir -p build/fuzz/found-containers
  # They ask for as much memory as a file says; the program has a limit, and its library then an error.
  ASAN_OPTIONS=allocator_may_return_null=1 build/fuzz/containers -max_total_time="${1:-60}" -timeout=60 -rss_limit_mb=4096 \
    -malloc_limit_mb=1000000 -max_len=8192 -print_final_stats=1 -detect_leaks=0 -artifact_prefix=build/fuzz/container- build/fuzz/found-containers tests/fuzz/containers
fi
[ ! -x build/bin/railbook ] || tests/fuzz/command_lines.sh "$PWD/build/bin/railbook" 1000 "$RANDOM"
