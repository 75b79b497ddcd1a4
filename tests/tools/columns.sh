#!/bin/sh
# columns.sh SOURCE RAILBOOK: each column of each table that the commands of docs/commands.txt write is explained in their --help.
source=$1 railbook=$2
folder=$(mktemp -d) || exit 1
trap 'rm -rf "$folder"' EXIT
mkdir "$folder/bin"
ln -s "$railbook" "$folder/bin/railbook"
ln -s "$source/tools/examples" "$folder/examples"
PATH=$folder/bin:$PATH
cd "$folder" || exit 1
missed=0 seen=0
units='m|mm|ms|mm2|um|N|kN|kN_m|N_m|MPa|cm|s|deg|rad|mrad|km|m_per_s|mph|m_per_s2|deg_per_s|rad_per_s|rad_per_km|rad_per_km2|1_per_m|1_per_s|kN_per_m'
while IFS='|' read -r name question command picture <&3; do
  case $name in '#'* | '') continue ;; esac
  # shellcheck disable=SC2086 # subject and verb
  railbook $name --help | tr -s ' \n' '  ' >help
  rm -rf out
  case $command in *--out* | *synthesize*) out= ;; *) out=' --out out' ;; esac
  sh -c "$command$out --no-figures" >answer 2>&1 || sh -c "$command$out" >answer 2>&1 || sh -c "$command" >answer 2>&1 || { cat answer; exit 1; }
  for table in out/*.csv forces/*.csv sensors.csv track.csv; do
    [ -f "$table" ] && [ "$table" -nt help ] || continue
    seen=$((seen + 1))
    for column in $(grep -v '^#' "$table" | head -n 1 | tr ',' ' '); do
      # Without its unit, the name of the data, the side, and "_is" of how far it can be trusted.
      bare=$(echo "$column" | sed -E "s/_($units)\$//; s/^profile_/NAME_/; s/_D[0-9]_/_D1_/; s/_chord_largest_at\$/_D1_largest_at/; s/_(of_mu|p_max)\$//; s/_R\$/_L/")
      side=$(echo "$bare" | sed -E 's/_(left|right)$//; s/_(left|right)_/_/; s/^.*_is$/NAME_is/; s/_(left|right)_is$/_is/')
      grep -qE "(^|[^A-Za-z0-9_])($column|$bare|$side)([^A-Za-z0-9]|_of|\$)" help || { echo "$name: ${table##*/}: $column is not in --help"; missed=1; }
    done
  done
done 3<"$source/docs/commands.txt"
[ "$seen" -ge 25 ] || { echo "only $seen tables"; missed=1; }
exit $missed
