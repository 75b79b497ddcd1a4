#!/bin/sh
# refuses.sh REASON PROGRAM ARGUMENTS...: the program must end with status 2, say why on stderr in words that
# match REASON (grep's basic syntax), and leave no folder behind that --out names.
reason=$1
shift
out= last=
for argument; do
  [ "$last" = --out ] && out=$argument
  last=$argument
done
[ -z "$out" ] || [ -f "$out" ] || rm -rf "$out"
said=$("$@" 2>&1 >/dev/null)
status=$?
echo "status $status: $said"
[ $status -eq 2 ] || exit 1
echo "$said" | grep -q -e "$reason" || exit 1
[ -z "$out" ] || [ -f "$out" ] || [ ! -e "$out" ]
