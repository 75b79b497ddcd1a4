#!/bin/sh
# chapter.sh BUILD NN-NAME, in the source's folder: the chapter's run that ctest judges, in BUILD/ctest/NN-NAME. It is the one
# that `make reproduce` has left if all its checks passed and nothing has changed since, or else one of its own, not timed.
if cmake/reproduce.sh --copy "$1" quick "$2" "$1/ctest/$2"; then
  echo "As \`make reproduce\` has left it: $(cat "$1/results/$2.txt")"
else
  exec "$1/bin/${2#*-}" reproduce --no-timings --out "$1/ctest/$2"
fi
