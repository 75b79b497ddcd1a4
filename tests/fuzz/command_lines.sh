#!/bin/bash
# command_lines.sh RAILBOOK COUNT SEED: random options of every tool at extreme values. Each run ends by itself within a minute,
# in less than 4 GB, with status 0 to 3; what is refused says why.
railbook=$1 count=$2 RANDOM=$3
folder=$(mktemp -d) || exit 1
trap 'rm -rf "$folder"' EXIT
cd "$folder" || exit 1
ulimit -v 4000000 2>/dev/null
ulimit -c 0
printf 'distance_m,profile_mm\n' >good.csv
for ((i = 0; i < 400; ++i)); do echo "$((i / 4)).$((25 * (i % 4))),$((RANDOM % 9))" >>good.csv; done
printf 'distance_m,profile_mm\n0,1e300\n1,-1e300\n2,nan\n' >wild.csv
# "SUBJECT TOOL|options", and the words that an option offers, from the completion, which has them all.
mapfile -t tools < <("$railbook" --completion bash | sed -n "s/^ *'\([a-z]* [a-z]*\)') offer='\(.*\)'$/\1|\2/p")
numbers=(0 -0 1 -1 5e-324 1e-300 1e-30 1e-9 1e-3 0.3 0.5 7 30 1e3 1e6 1e12 1e30 1e300 1.7976931348623157e308 1e400 nan inf -inf '')
units=('' m mm ft in km/h mph kN lbf MPa Pa GPa kg s Hz N/m N*s/m rad deg % kg/m cycle/m 1/m)
words=(new cn heumann full fastsim polach table friction dampers metric good.csv wild.csv none.csv . - hamming)
pick() { picked=${*:RANDOM % $# + 1:1}; }
value() {
  case $((RANDOM % 6)) in
    0) pick "${words[@]}" ;;
    *) pick "${numbers[@]}"; number=$picked; pick "${units[@]}"; picked=$number$picked ;;
  esac
}
failed=0
for ((n = 0; n < count; ++n)); do
  pick "${tools[@]}"
  tool=${picked%%|*} options=${picked#*|}
  read -ra options <<<"${options//--help/}"
  # shellcheck disable=SC2206
  line=($tool)
  ((RANDOM % 3)) || line+=(good.csv)
  for ((k = RANDOM % 6 + 1; k > 0; --k)); do
    pick "${options[@]}"
    case $picked in
      --out | --figure | --config) continue ;;
    esac
    option=$picked
    value
    line+=("$option=$picked")
  done
  timeout -k 1 60 "$railbook" "${line[@]}" --no-figures >said 2>&1 </dev/null
  status=$?
  if ((status > 3)); then
    printf 'BAD %d: %q ' "$status" "${line[@]}"; echo; tail -c 300 said; failed=1
  elif ((status > 0)) && ! [ -s said ]; then
    printf 'BAD: says nothing: %q ' "${line[@]}"; echo; failed=1
  elif grep -q -e 'std::\|bad_alloc\|terminate\|CLI::\|what()\|Aborted' said; then
    printf 'BAD: a library speaks: %q ' "${line[@]}"; echo; tail -c 300 said; failed=1
  fi
done
echo "$count command lines"
exit $failed
