#!/bin/sh
# habits.sh RAILBOOK: what people try first.
railbook=$1
folder=$(mktemp -d) || exit 1
trap 'rm -rf "$folder"' EXIT
cd "$folder" || exit 1
fail() { echo "$*"; exit 1; }
"$railbook" --version | grep -q "^with fmt [0-9.]*, CLI11 .*GSL [0-9.]*, FFTW" || fail "versions: $("$railbook" --version)"
"$railbook" --help | grep -q "quality index track.csv" || fail "no way from a file to a table in --help"
said() { # said STATUS PATTERN arguments...
  status=$1 pattern=$2
  shift 2
  "$railbook" "$@" >out 2>err
  [ $? -eq "$status" ] || fail "$*: not status $status: $(cat out err)"
  cat out err | grep -q -e "$pattern" || fail "$*: does not say $pattern: $(cat out err)"
}
said 2 'did you mean "psd"' pds
said 2 'did you mean "classify"' psd clasify
said 2 'did you mean "--column"' psd classify x.csv --colum profile
said 2 'did you mean "--column"' psd classify x.csv --colum=profile
said 2 'did you mean "hamming"' psd classify x.csv --window haming
printf 'distance_m,profil_mm\n0,1\n' >x.csv
said 2 'did you mean "profil"' psd classify x.csv
printf 'sped = "100km/h"\n' >bad.toml
said 2 'bad.toml", line 1.*did you mean "--speed"' quality limit bad.toml
said 2 "is no subject" frobnicate --help
said 0 'Example: ' psd classify --help

# JSON is JSON and nothing else; the answer can be made again from it.
"$railbook" quality limit --speed 100km/h --json >out 2>err || fail "json"
[ -s err ] && fail "json, and $(cat err)"
head -c 1 out | grep -q '{' || fail "no JSON: $(head -3 out)"
for key in '"program": "railbook"' '"version": "' '"command": \[' '"given": {' '"assumed": {' '"speed": "100km/h"' '"warnings": {'; do
  grep -q "$key" out || fail "JSON without $key"
done
"$railbook" creep curve --a 6mm --b 4mm --load 80kN --points 3 --json >out || fail "json"
[ "$(head -1 out)" = "{" ] && [ "$(tail -1 out)" = "}" ] || fail "not only JSON: $(tail -3 out)"
[ -e curve.csv ] && fail "files without --out"

# Pictures: one alone, on standard output, with the other files, or none.
"$railbook" quality limit --speed 100km/h --figure one.png >out || fail "figure"
[ "$(head -c 4 one.png | tail -c 3)" = PNG ] && [ "$(ls)" = "$(printf 'bad.toml\nerr\none.png\nout\nx.csv')" ] || fail "figure alone: $(ls)"
"$railbook" quality limit --speed 100km/h --figure - >two.png 2>err || fail "figure on standard output"
cmp one.png two.png || fail "another picture on standard output"
said 2 'allowed: one of them' quality limit --speed 100km/h --figure a.png --out mine
"$railbook" quality limit --speed 100km/h --out mine --no-figures >out || fail "no figures"
ls mine | grep -q png && fail "a figure in spite of --no-figures"
"$railbook" psd synthesize - --length 1km --json 2>err | grep -q '^distance_m' || fail "a record on standard output"
grep -q '"samples"' err || fail "its answer is lost: $(cat err)"

# Tools do not share file names, but for files that a tool reads.
all=$("$railbook" --completion bash | sed -n "s/^ *'\([a-z]* [a-z]*\)') offer=.*/\1/p")
[ "$(echo "$all" | wc -l)" -ge 15 ] || fail "tools: $all"
exit 0
