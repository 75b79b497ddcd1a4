#!/bin/sh
# verify.sh RAILBOOK DATA: `railbook verify` meets all its numbers, and one changed number of any file makes it fail and be named.
railbook=$1 data=$2
folder=$(mktemp -d) || exit 1
trap 'rm -rf "$folder"' EXIT
cd "$folder" || exit 1
fail() { echo "$*"; exit 1; }
"$railbook" verify --json >good.json 2>said || fail "status $?: $(cat said)"
grep -q '"failed": 0.0' good.json && grep -q '"warnings": {}' good.json || fail "a number is not met: $(cat good.json)"
[ "$(sed -n 's/^  "numbers": \([0-9]*\).*/\1/p' good.json)" -ge 500 ] || fail "fewer than 500 numbers"
groups=0
for file in "$data"/*.csv; do
  name=$(basename "$file" .csv)
  case $name in profile-*) continue ;; esac
  grep -q "\"${name}_worst\": [0-9.e-]*" good.json || fail "$name is not among the groups"
  rm -rf one && mkdir one && cp "$data"/profile-*.csv one
  # The last number by one and a half of what is allowed and what it is off at most.
  awk -F, -v OFS=, '{line[NR] = $0} END {for (i = 1; i < NR; ++i) if (i < 4) print line[i]; $0 = line[NR]; $3 += 2.5 * $4; printf "%s,%s,%.17g,%s\n", $1, $2, $3, $4}' "$file" >"one/$name.csv"
  "$railbook" verify --data one >said 2>error
  [ $? = 1 ] || fail "$name: a changed number does not end with status 1"
  of=$(tail -n 1 "$file" | cut -d, -f1)
  grep -q "WARNING: $of at .* expected: " said && grep -q "1 of 1 reference numbers are not met" error || fail "$name: $(cat said error)"
  groups=$((groups + 1))
done
[ $groups -ge 10 ] || fail "$groups groups"
printf '# a\n# b\nof,at,expected,within\nmoon-phase,1,2,3\n' >one/odd.csv
"$railbook" verify --data one 2>error && fail "a quantity that nobody knows is accepted"
grep -q '"moon-phase", which is not known' error || fail "$(cat error)"
printf '# a\n# b\nof,at,expected,within\nstroke-peak,soft,2,3\n' >one/odd.csv
"$railbook" verify --data one 2>error
[ $? = 2 ] && grep -q 'input 1 is "soft"; allowed: a number' error || fail "$(cat error)"
"$railbook" verify --data nowhere 2>error
[ $? = 2 ] && grep -q 'data is "nowhere"' error || fail "$(cat error)"
echo "$groups groups"
