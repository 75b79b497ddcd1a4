#!/bin/bash
# packages.sh SOURCE: of all targets of the Makefile only `packages`, `reproduce` and `test` install packages (with sudo).
cd "$1" || exit 1
installing=
for target in $(sed -n 's/^\([a-z-]*\):.*/\1/p' Makefile | sort -u); do
  commands=$(env -u MAKEFLAGS make -n "$target" C=01 NN=99-sample) || { echo "make -n $target: status $?"; exit 1; }
  [[ $commands != *"packages.sh install"* ]] || installing+=" $target"
done
[ "$installing" = " packages reproduce test" ] || { echo "packages are installed by:$installing"; exit 1; }
