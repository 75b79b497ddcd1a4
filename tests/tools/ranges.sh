#!/bin/sh
# ranges.sh SUBJECT RAILBOOK RANGES: options of the subject say what they allow when they are given a value that no range holds.
# RANGES has a line for each: SUBJECT TOOL OPTION UNIT RANGE, where "beyond 0" is from 0 without it. Options that tools share are in it once.
subject=$1 railbook=$2 ranges=$3
failed=0 n=0
while read -r of tool option unit range; do
  [ "$of" = "$subject" ] || continue
  n=$((n + 1))
  value=1e300
  case $range in
    beyond*)
      "$railbook" "$subject" "$tool" "$option=0${unit#-}" 2>&1 </dev/null | grep -q "is 0.*; allowed: greater than 0, finite$" ||
        { echo "$tool $option takes 0"; failed=1; }
      range=from${range#beyond}
      ;;
    from*) ;;
    *) value=-1e300 ;;
  esac
  said=$("$railbook" "$subject" "$tool" "$option=$value${unit#-}" 2>&1 </dev/null)
  [ "$?" = 2 ] && [ "${said##*; allowed: }" = "$range" ] || { echo "$tool $option is not $range: $said"; failed=1; }
done <"$ranges"
echo "$n ranges"
[ $n -gt 0 ] || failed=1
exit $failed
