#!/bin/sh
# defaults.sh SUBJECT RAILBOOK DEFAULTS EXAMPLES: what the options of the subject's tools are without being given. DEFAULTS has blocks
#   tool SUBJECT TOOL arguments...
#   OPTION STATED GIVEN OTHER
# where STATED is the default in --help ("-": its words say it), GIVEN the same in the units that it comes from ("=": as stated, "none": it cannot be given), and OTHER another
# value ("!": that is refused, "-": of no effect here, or shown in a block before). With all the defaults given, the answer and its files are those without, but for how they were asked;
# with another value of one they are others. Without --out a tool leaves no file. Every default that --help states is in DEFAULTS.
subject=$1 railbook=$2 defaults=$3 examples=$4 here=$(cd "$(dirname "$0")" && pwd)
folder=$(mktemp -d) || exit 1
trap 'rm -rf "$folder"' EXIT
cd "$folder" || exit 1
failed=0 n=0 blocks=0
"$railbook" --manual | sed 's/\\-/-/g' | awk -v of="$subject" '/^\.SH railbook / {tool = $3 == of ? $4 : ""} /^\.B --/ {option = $2} /^[^.].* \[[^]]*\]$/ && option && tool {
  sub(/.* \[/, ""); gsub(/[] ]/, ""); print tool, option, $0} !/^\.B/ {option = ""}' >stated
fail() { echo "$*"; failed=1; }
case $subject in
  psd | quality)
    "$railbook" psd synthesize track.csv --length 3km --spacing 25cm --roughness 5e-7m^2*cycle/m --corner 0.13cycle/m --dip 11mm \
      --noise 0.1mm >/dev/null || exit 1
    awk -F, -v OFS=, 'NR > 1 {$1 += 15; $2 = (1.2 + $1 / 1e4) * $2} 1' track.csv >later.csv
    awk -F, -v OFS=, 'NR == 1 {$3 = "place_cm"; $4 = "level_mm"} NR > 1 {$3 = 80 * $1; $4 = $2 / 2} 1' track.csv >columns.csv
    ;;
  filters)
    # Beside the ranges of the sensors: a value that is just outside, one that is just inside, a row that is just too fast.
    "$railbook" filters simulate --out sensors.csv --truth truth.csv --length 1000m --speeds 60mph 30mph --distances 100m 150m --rate 0.5m/s^2 --sensors typical >/dev/null || exit 1
    awk -F, -v OFS=, -f "$here/filters/beside.awk" sensors.csv >beside.csv
    ;;
  hunting) cp "$examples"/hunting/*.csv . ;;
esac
# answer FOLDER arguments...: files of the run and what it says, but for how it was asked.
answer() {
  to=$1
  shift
  rm -rf "$to" && mkdir "$to"
  # shellcheck disable=SC2086 # none or three words
  (cd "$to" && "$railbook" "$subject" "$@" $files --json >said 2>error) || { fail "$subject $*: $(cat "$to/error")"; return 1; }
  for json in "$to"/said "$to"/out/*.json*; do # to the tenth digit, since units are multiplied in another order
    [ -e "$json" ] || continue
    sed '/^ "program"/,$d; s/,"key":"[0-9a-f]*"//; /: "assumed",\{0,1\}$/d; s/,$//' "$json" |
      awk 'match($0, /: -?[0-9.]+(e[+-]?[0-9]+)?$/) {$0 = substr($0, 1, RSTART) sprintf(" %.10g", substr($0, RSTART + 2))} 1' >kept && mv kept "$json"
  done
  return 0
}
block() {
  [ -n "$tool" ] || return
  blocks=$((blocks + 1))
  # shellcheck disable=SC2086 # options
  answer without $tool && answer given $tool $all && { diff -r without given >differences || fail "$tool: not the defaults $all: $(head -5 differences)"; }
  if [ -n "$files" ]; then
    rm -rf bare && mkdir bare
    # shellcheck disable=SC2086 # options
    (cd bare && "$railbook" "$subject" $tool >../bare.txt 2>&1) || fail "$tool: $(cat bare.txt)"
    [ "$(ls bare)" = "" ] || fail "$tool: leaves $(ls bare) where it was not asked to"
  fi
  while read -r one value; do
    if [ "${value#!}" != "$value" ]; then
      # shellcheck disable=SC2046 # options
      "$railbook" "$subject" $(echo "$tool" | sed 's|\.\./||g') "$one=${value#!}" >error 2>&1
      { [ $? = 2 ] && grep -q "allowed: " error; } || fail "$tool: $one=${value#!} is not refused: $(tail -1 error)"
      continue
    fi
    # shellcheck disable=SC2086 # options
    answer other $tool "$one=$value" && diff -r without other >/dev/null && fail "$tool: the same with $one=$value"
  done <others
}
while read -r option stated given other rest; do
  case $option in
    "#"*) continue ;;
    tool)
      block
      tool='' all=''
      : >others
      [ "$stated" = "$subject" ] || continue
      tool="$given $other $rest"
      name=$given
      "$railbook" "$subject" "$given" --help | grep -q -e --no-figures && files="--no-figures --out out" || files=
      continue
      ;;
  esac
  [ -n "$tool" ] || continue
  n=$((n + 1))
  [ "$given" = "=" ] && given=$stated
  [ "$given" = none ] || all="$all $option=$given"
  [ "$other" = - ] || echo "$option $other" >>others
  echo "$name $option" >>listed
  [ "$stated" = - ] || grep -qxF -e "$name $option $stated" stated || fail "$name $option is stated as $(grep -e "^$name $option " stated)"
done <"$defaults"
block
while read -r name option _; do
  grep -qxF -e "$name $option" listed || fail "no default of $name $option is listed"
done <stated
echo "$n defaults in $blocks blocks"
[ "$n" -gt 0 ] && [ -s stated ] || failed=1
exit $failed
