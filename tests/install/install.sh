#!/bin/sh
# install.sh BUILD SOURCE CXX: what `cmake --install` makes works wherever it is moved, from anywhere, without the tree it was
# built from; an outside project builds against it.
build=$1 source=$2 compiler=$3
set -e
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
fail() { echo "$*"; exit 1; }
cmake --install "$build" --prefix "$folder/a place" >"$folder/said" 2>&1 || fail "$(tail -5 "$folder/said")"
mv "$folder/a place" "$folder/an other place"
there="$folder/an other place"
railbook="$there/bin/railbook"
cd "$folder"

"$railbook" --version | grep -q '^railbook [0-9]' || fail "no version"
grep -q "^.TH RAILBOOK 1" "$there/share/man/man1/railbook.1" || fail "no manual page"
"$railbook" verify >/dev/null || fail "its reference numbers are not met"
[ -s "$there/share/doc/railbook/copyright" ] || fail "no licence"
bash -c '. "$1/share/bash-completion/completions/railbook"; COMP_WORDS=(railbook psd cla) COMP_CWORD=2; _railbook; [ "${COMPREPLY[*]}" = classify ]' sh "$there" || fail "bash completes nothing"
bash -c '. "$1/share/bash-completion/completions/railbook"; COMP_WORDS=(railbook psd classify --wi) COMP_CWORD=3; _railbook; [ "${COMPREPLY[*]}" = --window ]' sh "$there" || fail "bash completes no option"
grep -q "^#compdef railbook" "$there/share/zsh/site-functions/_railbook" || fail "no zsh completion"
if command -v zsh >/dev/null; then zsh -n "$there/share/zsh/site-functions/_railbook" || fail "zsh completion"; fi
if command -v man >/dev/null; then
  man --warnings -l "$there/share/man/man1/railbook.1" >page 2>warnings </dev/null || fail "man: $(cat warnings)"
  grep -q "railbook psd classify" page || fail "the manual page lacks a tool"
fi

# Figures are drawn with what was installed, not with what stands in the tree.
"$railbook" track stiffness --out mine >/dev/null || fail "no figure"
[ -s mine/stiffness.png ] || fail "no figure"
"$railbook" quality index "$there/share/railbook/examples/quality/track.csv" --speed 100km/h --column crosslevel --out mine >/dev/null || fail "an example"
if grep -q "$source/" "$railbook"; then fail "the program knows where it was built: $(grep -ao "$source/[^[:space:]]*" "$railbook" | head -3)"; fi

# What reads HDF5 and MAT files, if it was built, is found from where the command is now.
if [ -x "$build/libexec/railbook/containers" ]; then
  printf '\211HDF\r\n\032\n' >damaged.h5
  "$railbook" psd classify damaged.h5 2>&1 | grep -q "the HDF5 file cannot be read" || fail "no reader of HDF5 files"
  grep -q "^PackageName: HDF5$" "$there/share/doc/railbook/railbook.spdx" || fail "HDF5 is not in railbook.spdx"
fi

# The notices of what is compiled in, and hardening of releases.
for work in Eigen CLI11 nlohmann-json fmt; do
  grep -q "^$work$" "$there/share/doc/railbook/copyright" || fail "no notice of $work"
  grep -q "^PackageName: $work$" "$there/share/doc/railbook/railbook.spdx" || fail "$work is not in railbook.spdx"
done
if grep -q '^CMAKE_BUILD_TYPE:.*=Release$' "$build/CMakeCache.txt" && command -v readelf >/dev/null; then
  readelf -d "$railbook" | grep -q BIND_NOW || fail "the command is linked without BIND_NOW"
  readelf -W --dyn-syms "$railbook" | grep -q __stack_chk_fail || fail "the command has no stack protector"
  readelf -W --dyn-syms "$railbook" | grep -q __memcpy_chk || fail "the command is compiled without _FORTIFY_SOURCE"
fi

# The Debian package names what it needs, is the same whoever packs it, and its command runs where it is unpacked.
if command -v dpkg-shlibdeps >/dev/null; then
  cpack --config "$build/CPackConfig.cmake" -B "$folder/package" >said 2>&1 || fail "$(tail -5 said)"
  package=$(echo "$folder"/package/railbook_*.deb)
  dpkg-deb -f "$package" Depends | grep -q libfftw3 || fail "the package forgets FFTW"
  [ ! -x "$build/libexec/railbook/containers" ] || dpkg-deb -f "$package" Depends | grep -q libhdf5 || fail "the package forgets HDF5"
  (umask 077 && cpack --config "$build/CPackConfig.cmake" -B "$folder/elsewhere" >said 2>&1) || fail "$(tail -5 said)"
  cmp "$package" "$folder"/elsewhere/railbook_*.deb || fail "a second package differs"
  dpkg-deb -x "$package" unpacked
  ./unpacked/usr/bin/railbook --version | grep -q '^railbook [0-9]' || fail "the package's command does not run"
  [ -s unpacked/usr/share/railbook/lib/plot/style.gp ] || fail "the package lacks the figures' style"
fi

if find "$there" -name '*.a' | xargs -d '\n' grep -q "$source/"; then fail "the library knows where it was built"; fi
if grep -rq "$source" "$there/lib"*/cmake "$there/lib"*/*/cmake 2>/dev/null; then fail "the package knows where it was built"; fi
version=$(sed -n 's/^CMAKE_PROJECT_VERSION:.*=//p' "$build/CMakeCache.txt")
cmake -S "$source/tests/install/outside" -B outside -DCMAKE_CXX_COMPILER="$compiler" "-DCMAKE_PREFIX_PATH=$there" "-DVERSION=$version" >said 2>&1 || fail "$(tail -20 said)"
cmake --build outside >said 2>&1 || fail "$(tail -20 said)"
./outside/outside >answer || fail "$(cat answer)"

# The same program in a project that takes in the sources: no program, no test and no book comes with them, nor what these need.
# Once its libraries are static and compiled file by file, once shared, and each compiled in one piece.
unneeded=$(printf -- ' -DCMAKE_DISABLE_FIND_PACKAGE_%s=TRUE' CLI11 nlohmann_json PNG Catch2 pybind11)
for way in "" "-DFETCH=ON -DBUILD_SHARED_LIBS=ON -DCMAKE_UNITY_BUILD=ON -DCMAKE_UNITY_BUILD_BATCH_SIZE=0"; do
  rm -rf sub
  # shellcheck disable=SC2086 # options
  cmake -S "$source/tests/install/subproject" -B sub -DCMAKE_CXX_COMPILER="$compiler" "-DRAILBOOK=$source" -DRAILBOOK_PCH=OFF \
    -DGNUPLOT=GNUPLOT-NOTFOUND -DPANDOC=PANDOC-NOTFOUND $unneeded -DCMAKE_BUILD_TYPE=Debug -DCMAKE_CXX_FLAGS=-O0 $way >said 2>&1 || fail "$(tail -20 said)"
  cmake --build sub --target subproject -j2 >said 2>&1 || fail "$(tail -20 said)"
  ./sub/subproject | cmp - answer || fail "the sources taken in answer otherwise: $way"
  if grep -q "railbook/tools\|railbook_report" sub/build.ninja sub/Makefile 2>/dev/null; then fail "more than the library is taken in"; fi
  [ -z "$way" ] || [ -n "$(find sub -name "librailbook_contact.so.${version%.*}")" ] || fail "a shared library without its version"
done
