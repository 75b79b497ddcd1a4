#!/bin/sh
# no_memory.sh RAILBOOK PRELOAD: wherever memory ends, a command ends with status 3 and the files of an earlier run as they
# were, or with the whole answer.
railbook=$1 preload=$2
folder=$(mktemp -d) || exit 1
trap 'rm -rf "$folder"' EXIT
cd "$folder" || exit 1
fail() { echo "$*"; exit 1; }
"$railbook" psd synthesize track.csv --length 3km --seed 1 --roughness 5e-7m^2*cycle/m >/dev/null || fail "synthesize"
check() { # a command, with the allocations sampled over the whole run and all of its last ones, where the files are put in place
  rm -rf out right
  COUNT_TO=count LD_PRELOAD=$preload "$railbook" "$@" --no-figures --out out >/dev/null || fail "$*"
  total=$(cat count)
  mv out right
  for n in 1 3 10 100 1000 $(seq 5000 $((total / 12)) "$total") $(seq $((total - 40)) "$total"); do
    rm -rf out && mkdir out
    for file in right/*; do echo old >"out/${file#right/}"; done
    cp -r out before
    FAIL_AT=$n LD_PRELOAD=$preload timeout 60 "$railbook" "$@" --no-figures --out out >/dev/null 2>error
    case $? in
      0) diff -r out right >/dev/null || fail "$*: status 0 and other files than without allocation $n failing" ;;
      3) diff -r out before >/dev/null || fail "$*: status 3, and allocation $n leaves $(ls -A out)" ;;
      *) fail "$*: allocation $n ends in another way: $(cat error)" ;;
    esac
    rm -rf before
  done
}
check contact solve --body-1-radius-across 0.3m --body-1-radius-along .46m --load 100kN --cells-x 24 --cells-y 24
check creep curve --a 6mm --b 4mm --load 80kN --mu 0.3
check hunting speed
check psd classify track.csv
check quality index track.csv --speed 100km/h
check track joint --speed 60mph --dip 0.5in
check wheelrail contact --load 50kN --speed 30m/s --method strips
