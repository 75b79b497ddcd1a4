#!/bin/sh
# ranges.sh SUBJECT RAILBOOK: every option of the subject's tools that takes a quantity or a count, as --help lists them, refuses
# (status 2) what is outside of the range that its own message states, beyond either end, and names the range again.
subject=$1 railbook=$2
failed=0 n=0
fail() { echo "$subject $*"; failed=1; }
# said VALUE: what the tool says of the option with that value, and its status
said() { answer=$("$railbook" "$subject" "$tool" "$option=$1${unit:+ $unit}" 2>&1 </dev/null) && status=0 || status=$?; }
for tool in $("$railbook" "$subject" --help | sed -n '/^Subcommands:/,/^$/ s/^  \([a-z]\{1,\}\) .*/\1/p'); do
  for option in $("$railbook" "$subject" "$tool" --help | sed -n 's/^ *\(--[a-z0-9-]*\) \(QUANTITY\|COUNT\).*/\1/p'); do
    # A wrong unit is refused by the name of the right one; without a unit the tool would be run.
    unit=$("$railbook" "$subject" "$tool" "$option=1 kg*m^9" 2>&1 | sed -n 's/.*; allowed: a unit of \([^ ]*\)$/\1/p' | head -1)
    name=$(echo "${option#--}" | tr - ' ')
    for sign in "" -; do
      said "${sign}1e300"
      case $answer in *"$name is ${sign}1e+300"*"; allowed: "*) ;; *) continue ;; esac # no end there
      n=$((n + 1))
      [ $status = 2 ] || fail "$tool $option=${sign}1e300: status $status"
      range=${answer##*; allowed: }
      end=$(echo "$range" | awk -v high="$sign" '{v = "none"; if ($1 == "from") v = high == "" ? $4 : $2; else if ($2 == "least" || $2 == "than") v = $3; print v}' | tr -d ,)
      [ "$end" != none ] || { fail "$tool $option: no end in \"$range\""; continue; }
      beyond=$(awk -v v="$end" -v sign="$sign" 'BEGIN {d = (v < 0 ? -v : v) / 1000 + (v == 0); if (v == int(v) && v < 1e6 && v > -1e6) d = 1; printf "%.12g", sign == "" ? v + d : v - d}')
      said "$beyond"
      [ $status = 2 ] && [ "${answer##*; allowed: }" = "$range" ] || fail "$tool $option=$beyond is not $range: $answer"
    done
  done
done
echo "$n ends of ranges"
[ $n -gt 0 ] || failed=1
exit $failed
