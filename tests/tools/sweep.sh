#!/bin/sh
# sweep.sh PROGRAM SUBJECT TOOL [--option=value | argument ...]: every option of the tool that takes a quantity or a count, as
# --help lists them, at 0, at the ends of what a double holds, and at -1, in its own SI unit, with the arguments given for the
# rest. The tool must answer (0) or refuse (2; 3 where the outside failed) within 20 seconds: no signal, no bad_alloc.
program=$1 subject=$2 tool=$3
shift 3
ulimit -v 8000000 2>/dev/null
ulimit -c 0
folder=$(mktemp -d) || exit 1
trap 'rm -rf "$folder"' EXIT
failed=0 runs=0

# run OPTION VALUE arguments...: the tool with OPTION=VALUE in place of what the arguments say of it.
run() {
  option=$1 value=$2
  shift 2
  for argument; do
    shift
    case $argument in "$option="*) ;; *) set -- "$@" "$argument" ;; esac
  done
  timeout -k 1 20 "$program" "$subject" "$tool" "$@" "$option=$value" >"$folder/out" 2>"$folder/err" </dev/null
  status=$?
  runs=$((runs + 1))
  case $status in
    0 | 2 | 3) grep -q "bad_alloc\|std::\|vector::\|basic_string" "$folder/err" || return ;;
  esac
  echo "$subject $tool $* $option=$value: status $status: $(head -c 300 "$folder/err")"
  failed=1
}

# The base itself is a run that must answer.
"$program" "$subject" "$tool" "$@" >"$folder/out" 2>"$folder/err" </dev/null ||
  { echo "the base fails: $(head -c 300 "$folder/err")"; exit 1; }
options=$("$program" "$subject" "$tool" --help | sed -n 's/^ *\(--[a-z0-9-]*\) \(QUANTITY\|COUNT\).*/\1/p')
[ -n "$options" ] || { echo "no options in the help of $subject $tool"; exit 1; }
for name in $options; do
  # The message about a wrong unit names the one that is due; without one the tool would be run.
  unit=$("$program" "$subject" "$tool" "$name=1 kg*m^9" 2>&1 | sed -n 's/.*; allowed: a unit of \([^ ]*\)$/\1/p' | head -1)
  for number in 0 1e-300 5e-324 1e300 -1; do run "$name" "$number${unit:+ $unit}" "$@"; done
done
echo "$runs runs, $(echo "$options" | wc -l) options"
exit $failed
