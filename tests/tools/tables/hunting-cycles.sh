# Sourced by tables.sh.
. "$cases/hunting-profiles.sh"
# branches WHAT FOLDER [some]: each branch by its own points. It turns round where it has a fold, which is beyond
# the points to either side (twice more where two are within a step); between two points the number
# of multipliers outside changes where a special point is between them, by one or, at a torus, by two; (of a branch with corners only some of these
# are special points), and special points are told in order as they are listed.
branches() {
  tail -n +2 "$2/special.csv" >points.csv
  awk -F, -v some="$3" 'function between(x, p, q, slack) {return (x - p) * (x - q) <= slack * (p - q) ^ 2} function abs(x) {return x < 0 ? -x : x} function bad(text) {print text; wrong++}
    FNR == NR {++specials[$1]; V[$1, specials[$1]] = $2; A[$1, specials[$1]] = $3; kind[$1, specials[$1]] = $4; next}
    FNR == 1 {next}
    {b = $1; n = ++points[b]; v[b, n] = $2; a[b, n] = $3; outside[b, n] = $10; if (n > 2) turns[b] += (v[b, n] - v[b, n - 1]) * (v[b, n - 1] - v[b, n - 2]) < 0}
    END {for (b in points) {folds = 0; i = 1
      for (k = 1; k <= specials[b]; ++k) {what = kind[b, k] " at " V[b, k] " of branch " b; ++all
        fold = kind[b, k] == "fold"; folds += fold
        at = 0; nearest = 1e300
        for (j = i; j < points[b]; ++j) {x = V[b, k] - v[b, j]; y = V[b, k] - v[b, j + 1]; d = abs(x) + abs(y)
          if (between(A[b, k], a[b, j], a[b, j + 1], 0.1) && (fold ? x * y >= 0 : between(V[b, k], v[b, j], v[b, j + 1], 0.1)) && d < nearest) {at = j; nearest = d}}
        if (at == 0 || nearest > 0.04 * V[b, k] && fold) {bad("no points about the " what); break}
        i = at
        changes[b, i] += kind[b, k] == "torus" ? 2 : 1}
      if (folds > turns[b] || (turns[b] - folds) % 2 != 0) bad("branch " b ": " folds " folds, " turns[b] " turns")
      for (i = 1; i < points[b] && some == ""; ++i) {d = abs(outside[b, i + 1] - outside[b, i]); if (d > changes[b, i] || (changes[b, i] - d) % 2 != 0 || (changes[b, i] == 1 && d != 1)) bad("branch " b " at " v[b, i] ": " d " multipliers, " changes[b, i] + 0 " special")}}
    exit wrong > 0 || all == 0}' points.csv "$2/cycle.csv" >said || fail "$1: $(head -4 said)"
  awk -F, '{key = $1 == 1 ? "branch" : "secondary_" $1 - 1; print key "_special_" ++n[$1], $2, $3, $4}' points.csv >specials
  while read -r key speed mm kind; do
    near "the speed of $key" "$(v "$2" "${key}_m_per_s")" "$speed" 1e-5
    near "the amplitude of $key" "$(v "$2" "${key}_mm")" "$mm" 1e-5
    feet=$(sed -n "s/.*\"${key}_m_per_s\": \"\(error not known; \)\{0,1\}\([0-9.]*\) ft\/s\(, not located closely\)\{0,1\}\(; the branch that leaves here is not followed\)\{0,1\}\".*/\2/p" "$2.json")
    awk -v s="$speed" -v feet="$feet" 'BEGIN {d = feet * 0.3048 / s - 1; exit !(d < 1e-3 && d > -1e-3)}' || fail "$key in feet: $(grep "$key" "$2.json")"
    [ -n "$kind" ] || fail "a special point of no kind"
  done <specials
  [ "$(sed '/"errors": {/q' "$2.json" | grep -c '_special_[0-9]*_m_per_s": [0-9]')" = "$(wc -l <specials)" ] || fail "$1: special points that are not listed"
}
# crossings FOLDER SPEED: how often the branches pass a speed.
crossings() {
  awk -F, -v s="$2" 'NR > 1 {n += $1 == b && (before - s) * ($2 - s) < 0; b = $1; before = $2} END {print n + 0}' "$1/cycle.csv"
}
answers short cycle --half-truck-distance 3m
branches "short trucks" short
answers cn cycle --pair cn
branches "the worn pair" cn
answers second cycle --family 2
branches "the second family" second some
# Lopsided cycles leave where symmetry breaks: to the left or to the right of the middle, those of the branch itself about it, and come back to where it holds again.
awk -F, '$1 == 1 && $4 == "symmetry breaking" {print $2}' short/special.csv | xargs >breaks
[ "$(wc -w <breaks)" = 2 ] || fail "symmetry breaks at $(cat breaks)"
holds "lopsided cycles" short/cycle.csv '
  $1 == 1 {near($c["middle_mm"], 0, 1e-12)}
  $1 == 2 {++aside; m = $c["middle_mm"]; if (m == 0 || m * side < 0) {print "middle", m; wrong++} side = m; if (!($2 > low && $2 < high)) {print $2; wrong++} if (aside == 1 || $2 < least) least = $2; if ($2 > most) most = $2}
  END {near(least, low, 0.5); near(most, high, 0.5); near(aside > 10, 1, 0)}' low="$(cut -d' ' -f1 breaks)" high="$(cut -d' ' -f2 breaks)"
grep -q '"secondary_1_points": "back on a branch of more symmetry"' short.json || fail "the end of lopsided cycles: $(grep secondary_1_points short.json)"
grep -q '"secondary_2' short.json && fail "lopsided cycles from their other end"
grep -q 'cycle 1 at\|"cycles"' short.json && fail "cycles of no speed"
# At a speed there are as many cycles as branches pass it; two meet at a fold.
fold=$(awk -F, '$4 == "fold" {print $2; exit}' short/special.csv)
for speed in 43 45 50 "$(awk -v f="$fold" 'BEGIN {print f - 0.1}')" "$(awk -v f="$fold" 'BEGIN {print f + 0.1}')"; do
  answers at cycle --half-truck-distance 3m --speed "${speed}m/s"
  n=$(crossings short "$speed")
  near "cycles at $speed m/s" "$(v at cycles)" "$n" 0
  for k in $(seq "$n"); do
    mm=$(v at "cycle_${k}_mm")
    awk -F, -v s="$speed" -v a="$mm" 'NR > 1 {if ($1 == b && (before - s) * ($2 - s) < 0) {x = size + ($3 - size) * (s - before) / ($2 - before); d = x - a; if (d < 0) d = -d; if (d < 0.02 * a) found = 1} b = $1; before = $2; size = $3} END {exit !found}' short/cycle.csv ||
      fail "cycle $k at $speed m/s is not on the branches: $mm mm"
  done
  if [ "$n" = 0 ]; then says="none on what was searched; other branches may have some"; else says=; fi
  [ "$(sed -n 's/^  "cycles": "\(.*\)",\{0,1\}$/\1/p' at.json)" = "$says" ] || fail "no cycles at $speed m/s: $(grep '"cycles"' at.json)"
done
# On cones every amplitude is a cycle at one speed, neither stable nor not.
# shellcheck disable=SC2086 # options
answers neutral cycle $cones --average 0mm --first-amplitude 0.2mm --largest-amplitude 1mm
holds "cycles on cones" neutral/cycle.csv '{near($2, hopf, 1e-4); near($c["stable_mm"] == "nan" && $c["unstable_mm"] == "nan", 1, 0); near($c["unstable_multipliers"], 0, 0)} END {near(rows > 3, 1, 0)}' hopf="$(v neutral hopf_m_per_s)"
grep -q '"branch_stability": "neutral: one of many at this speed"' neutral.json || fail "cycles on cones are not called neutral"
# shellcheck disable=SC2086 # options
answers neutral cycle $cones --average 0mm --first-amplitude 0.2mm --largest-amplitude 1mm --speed "$(awk -v h="$(v neutral hopf_m_per_s)" 'BEGIN {print h + 1}')m/s"
near "cycles beside the cones' speed" "$(v neutral cycles)" 0 0
# What is told of stability is what the multipliers say.
answers stable cycle --pair cn --speed 132ft/s
for k in 1 2; do
  said=$(sed -n "s/^  \"cycle_${k}_multiplier\": \"\([a-z].*\)\",\{0,1\}$/\1/p" stable.json)
  awk -v m="$(v stable cycle_${k}_multiplier)" -v said="$said" 'BEGIN {exit !(m <= 1 + 1e-4 ? said == "stable" : said ~ /^unstable, [1-9] multipliers outside$/)}' || fail "a cycle of multiplier $(v stable cycle_${k}_multiplier) is $said"
done
# Next to a fold the multiplier is 1 within its error, and the answer says so; farther away it does not.
fold=$(grep -o '"branch_special_1_m_per_s": [0-9.]*' stable.json | head -1 | sed 's/.*: //')
answers edge cycle --pair cn --speed "$(awk -v f="$fold" 'BEGIN {printf "%.10f", f + 1e-8}')m/s"
grep -q 'Floquet multiplier is 1 within its error, and whether it is stable is not certain' edge.json || fail "a fold: $(grep multiplier edge.json)"
grep -q 'is not certain' stable.json && fail "stability away from a fold is certain: $(grep certain stable.json)"
# A search that reaches its number of points says so, with what it had; one that does not, does not.
answers hasty cycle --suspension friction --wheel-rail-friction 0.3 --points 30
{ grep -q '"points": "the search was stopped after 30 points: branches end early' hasty.json && grep -q '"branch_points": "stopped before its end"' hasty.json; } || fail "points: $(grep -i stop hasty.json)"
# With friction the branch begins at 3 % of the first amplitude.
awk -F, 'NR == 2 {d = $3 / 0.03 - 1; exit !(d < 1e-3 && d > -1e-3)}' hasty/cycle.csv || fail "the first amplitude with friction: $(sed -n 2p hasty/cycle.csv)"
# One whose first step is its last has not been stopped.
answers brief cycle --pair cn --first-amplitude 2mm --largest-amplitude 2mm
near "points of a branch that ends at once" "$(v brief branch_points)" 2 0
grep -q 'the search was stopped' brief.json && fail "the number of points was not reached"
grep -q 'the search was stopped' cn.json && fail "a branch that has time"
# In another datum a cycle is followed up to the factor, or down to it, and begins where it was found.
for factor in 1.05 0.95; do
  answers datum cycle --pair cn --speed 132ft/s --largest-amplitude 11mm --against wheelset-mass --factor $factor
  awk -v x="$(v datum cycle_1_against)" -v f=$factor 'BEGIN {x /= 76.6 * 14.59390293720636; exit !(f > 1 ? x >= 1 && x < 1.12 : x <= 1 && x > 0.88)}' || fail "a wheelset of $factor times its mass: $(v datum cycle_1_against)"
  grep -q '"cycle_1_against": "kg"' datum.json && grep -q '"cycle_1_against": "[a-z ]*; [0-9.]* mm, \(stable\|unstable, [1-9] multipliers outside\)"' datum.json || fail "a followed cycle: $(grep against datum.json)"
done
# Unlike sides: small cycles are about where the wheelsets rest, as the table has it.
sides="--wheel worn-wheel.csv --rail new-rail.csv --right-wheel new-wheel.csv --noise 0.003mm --first-amplitude 0.2mm --largest-amplitude 2mm"
# shellcheck disable=SC2086 # options
answers unlike cycle $sides
speed=$(awk -F, 'NR == 2 {low = high = $2} NR > 1 && $2 < low {low = $2} NR > 1 && $2 > high {high = $2} END {printf "%.6f", (low + high) / 2}' unlike/cycle.csv)
# shellcheck disable=SC2086 # options
answers beside cycle $sides --speed "${speed}m/s"
awk -F, -v s="$speed" -v m="$(v beside cycle_1_middle_mm)" -v a="$(v beside cycle_1_mm)" -v w="$(v beside cycle_1_rad_per_s)" 'NR > 2 && (before - s) * ($2 - s) <= 0 {x = (s - before) / ($2 - before); near(m, middle + ($14 - middle) * x); near(a, size + ($3 - size) * x); near(w, omega + ($4 - omega) * x); ++found}
  {before = $2; middle = $14; size = $3; omega = $4} function near(value, y, d) {d = value - y; if (d < 0) d = -d; if (!(d < 0.03 * (y < 0 ? -y : y) + 1e-3)) {print value, "is not", y; wrong++}} END {exit wrong > 0 || !found}' unlike/cycle.csv >said ||
  fail "a cycle of unlike sides: $(cat said)"
{ v beside cycle_1_middle_mm; sed -n 's/^  "cycle_1_middle_mm": "to the left of the centre; \(.*\) mm the others".*/\1/p' beside.json; sed -n 's/.*"rest_mm": "\(.*\) mm to the left".*/\1/p' beside.json; } | tr -d ' ' | tr '\n' , >middles
awk -F, '{for (k = 1; k <= 4; ++k) {d = $k - $(k + 4); if (d > 0.05 || d < -0.05) exit 1; if ($(k + 4) ^ 2 > 1e-3) off = 1} exit !(off && NF == 9)}' middles || fail "the middles of cycles: $(cat middles)"
