#!/bin/sh
# chapter.sh BUILD NN-NAME, in the source's folder: the chapter's run that ctest judges, in BUILD/ctest/NN-NAME. It is the one that
# `make reproduce` has left if all its checks passed and nothing has changed since, or else one of its own, not timed.
build=$1 chapter=$2 to=$1/ctest/$2
if [ -f "$build/results/$chapter.stamp" ] && cmake/chapter_stamp.sh "$build" "$chapter" quick | cmp -s - "$build/results/$chapter.stamp"; then
  for file in "results/$chapter" "results/$chapter.json" "results/$chapter.txt" "results/$chapter.files" "figures/$chapter"; do
    mkdir -p "$to/${file%/*}" && rm -rf "${to:?}/$file" && cp -R "$build/$file" "$to/$file" || exit
  done
  echo "As \`make reproduce\` has left it: $(cat "$build/results/$chapter.txt")"
else
  exec "$build/bin/${chapter#*-}" reproduce --no-timings --out "$to"
fi
