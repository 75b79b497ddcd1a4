#!/bin/sh
# chapter_stamp.sh BUILD NN-NAME LEVEL, in the source's folder: what the chapter's run was made of (its program, what it reads, the level) and
# what it left, as checksums. The target `reproduce` writes it after a run; ctest asks whether it still holds.
{ echo "$3" && find "chapters/$2" lib -type f ! -name '*.?pp' ! -name CMakeLists.txt | LC_ALL=C sort | xargs cat "$1/bin/${2#*-}"; } | sha256sum
sha256sum < "$1/results/$2.json"
