#!/bin/sh
# tables.sh SUBJECT RAILBOOK [CASES]: the tables that tools write say what their answers say, and keep the laws of what they are about.
# The cases are in tables/CASES.sh, or tables/SUBJECT.sh.
subject=$1 railbook=$2 cases=$(cd "$(dirname "$0")" && pwd)/tables
folder=$(mktemp -d) || exit 1
trap 'rm -rf "$folder"' EXIT
cd "$folder" || exit 1
fail() { echo "$*"; exit 1; }
# answers FOLDER arguments...: files in FOLDER, the answer as JSON in FOLDER.json.
answers() {
  to=$1
  shift
  "$railbook" "$subject" "$@" --no-figures --out "$to" --json >"$to.json" 2>said || fail "$*: $(cat said)"
  sed '/"warnings": {/q' "$to.json" | grep '^  "[^"]* [^"]*": ' && fail "$*: a key with a space in it"
}
# draws FOLDER arguments...: as answers, with a gnuplot that leaves what it is given to draw in FOLDER.drawn/1/d1.csv and so on.
draws() {
  to=$1
  shift
  mkdir "$to.drawn"
  printf '#!/bin/sh\nto=%s/$(ls %s | wc -l | xargs expr 1 +)\nmkdir "$to" && cp ./*.csv "$to" && printf "\\211PNG\\r\\n\\032\\nIEND\\256B\\140\\202" >out.png\n' \
    "$folder/$to.drawn" "$folder/$to.drawn" >"$to.gnuplot"
  chmod +x "$to.gnuplot"
  RAILBOOK_GNUPLOT=$folder/$to.gnuplot "$railbook" "$subject" "$@" --out "$to" --json >"$to.json" 2>said || fail "$*: $(cat said)"
}
# v FOLDER KEY: a number of the answer.
v() { sed -n "s/^  \"$2\": \(-\?[0-9][0-9.e+-]*\),\?\$/\1/p" "$1.json" | head -1; }
# near WHAT VALUE EXPECTED WITHIN
near() { awk -v a="$2" -v b="$3" -v within="$4" 'BEGIN {exit !(a != "" && a - b <= within && b - a <= within)}' || fail "$1: $2 is not $3"; }
# holds WHAT FILE PROGRAM assignments...: an awk program over a CSV, columns by name in c, that counts what is wrong in `wrong`. $functions: of
# awk, for the program.
holds() {
  what=$1 file=$2 program=$3
  shift 3
  # shellcheck disable=SC2046 # one word each
  awk $(for one in "$@"; do echo "-v $one"; done) -F, "$functions"'function abs(x) {return x < 0 ? -x : x}
    function near(x, y, within) {if (y == "" || !(abs(x - y) <= within)) {print x, "is not", y; wrong++}}
    NR == 1 {for (i = 1; i <= NF; ++i) c[$i] = i; next} {++rows} '"$program"' END {exit wrong > 0 || rows == 0}' "$file" >said ||
    fail "$what: $(head -5 said)"
}
# means FOLDER PROGRAM assignments...: an awk program over the answer's values v[key], errors[key], notes[key] and units[key]. is(key, expected, within)
# compares, relative to the expected value and to 1e-6 where nothing else is said; says(key, pattern) looks into a text or a note,
# warns(key, pattern) into a warning.
# Every value must be named by one of them or by free(keys); warnings(keys) names all the warnings.
functions=
means() {
  answer=$1.json program=$2
  shift 2
  # shellcheck disable=SC2046 # one word each
  sed -n 's/^ "\(values\|errors\|units\|notes\|warnings\)": {.*/\1/p; s/,$//; s/^  "\([^"]*\)": "\{0,1\}\(.*[^"]\)"\{0,1\}$/\1\t\2/p; /^ "program"/q' "$answer" |
    awk $(for one in "$@"; do echo "-v $one"; done) -F'\t' "$functions"'function abs(x) {return x < 0 ? -x : x}
    function bad(text) {print text; wrong++}
    function is(key, x, within) {named[key]; if (within == "") within = 1e-6
      if (!(key in v) || !(abs(v[key] - x) <= within * (x == 0 ? 1 : abs(x)))) bad(key " is " v[key] ", not " x)}
    function says(key, pattern) {named[key]; if ((v[key] " | " notes[key]) !~ pattern) bad(key " does not say " pattern ": " v[key] " | " notes[key])}
    function free(keys, all, n) {n = split(keys, all, " "); for (; n > 0; --n) {named[all[n]]; if (!(all[n] in v)) bad("no " all[n])}}
    function warns(key, pattern) {expected[key]; if (flag[key] !~ pattern) bad("warning " key " does not say " pattern ": " flag[key])}
    function warnings(keys, all, n) {n = split(keys, all, " "); for (; n > 0; --n) {expected[all[n]]; if (!(all[n] in flag)) bad("no warning " all[n])}}
    NF == 1 {section = $1; next}
    section == "values" {v[$1] = $2; ++rows} section == "errors" {errors[$1] = $2} section == "units" {units[$1] = $2} section == "notes" {notes[$1] = $2} section == "warnings" {flag[$1] = $2}
    END {pi = 3.14159265358979; '"$program"'
      for (key in v) if (!(key in named)) bad(key " is not asked for: " v[key])
      for (key in flag) if (!(key in expected)) bad("warning " key ": " flag[key])
      exit wrong > 0 || rows == 0}' >said || fail "$answer: $(head -9 said)"
}

[ -f "$cases/${3:-$subject}.sh" ] || fail "no tables of ${3:-$subject} are known"
# shellcheck source=/dev/null
. "$cases/${3:-$subject}.sh"
exit 0
