#!/bin/bash
# failures.sh RAILBOOK PRELOAD EXAMPLES KIND: wherever a call of the kind fails, a command ends with status 3 and the files of an
# earlier run as they were, or with the whole answer. Only a few places of each command are tried: the first, the last, and some between.
railbook=$1 preload=$2 examples=$3
export FAIL_CALL=$4
folder=$(mktemp -d) || exit 1
trap 'rm -rf "$folder"' EXIT
cd "$folder" || exit 1
bad=0 runs=0
fail() { echo "$FAIL_CALL: $*"; bad=1; }
case $FAIL_CALL in fork | open) figures=() ;; *) figures=(--no-figures) ;; esac # gnuplot is a process and reads scripts
"$railbook" psd synthesize track.csv --length 3km --seed 1 --roughness 5e-7m^2*cycle/m >/dev/null || exit 1
"$railbook" psd synthesize later.csv --length 3km --seed 1 --roughness 5e-7m^2*cycle/m --noise 0.1mm >/dev/null || exit 1
"$railbook" filters simulate --out sensors.csv --length 1000ft >/dev/null || exit 1
places() { # of so many calls
  if [ "$FAIL_CALL" = memory ]; then
    echo 1 3 10 100 1000 $(seq 5000 $(($1 / 8 + 1)) "$1") $(seq $(($1 > 20 ? $1 - 20 : 1)) "$1")
  else
    echo $(seq 1 $(($1 / 8 + 1)) "$1") $(seq $(($1 > 4 ? $1 - 4 : 1)) "$1")
  fi
}
try() { # try OUT COMMAND...: OUT is what the command writes, a folder or a file, or - for standard output
  local out=$1 total n status
  shift
  rm -rf out right before && mkdir out right
  COUNT_TO=$folder/count LD_PRELOAD=$preload "$railbook" "$@" >right.text 2>error || { fail "$*: $(cat error)" && return; }
  total=$(cat count)
  mv out right/out
  [ -f "$out" ] && mv "$out" right/file
  for n in $(places "$total"); do
    mkdir out
    for file in right/out/*; do [ -f "$file" ] && echo old >"out/${file##*/}"; done
    [ -f right/file ] && echo old >"$out"
    rm -rf before && cp -r out before
    timeout 120 env FAIL_AT="$n" LD_PRELOAD="$preload" "$railbook" "$@" >text 2>error
    status=$? runs=$((runs + 1))
    case $status in
      0) diff -r out right/out >/dev/null && { [ ! -f right/file ] || cmp -s "$out" right/file; } && cmp -s text right.text ||
        fail "$*: status 0 and another answer than without call $n of $total failing" ;;
      3) diff -r out before >/dev/null && { [ ! -f right/file ] || [ "$(cat "$out")" = old ]; } ||
        grep -qs '"failed","reason":"not enough memory"\|,failed,not enough memory' out/*-table.csv || # many rows: the one that failed says so
        fail "$*: status 3, and call $n of $total leaves $(ls -A out)" ;;
      *) fail "$*: call $n of $total ends with status $status: $(cat error)" ;;
    esac
    rm -rf out
  done
}
answer() { try - "$@" "${figures[@]}" --out out; }
answer contact solve --body-1-radius-across 0.3m --body-1-radius-along .46m --load 100kN --cells-x 24 --cells-y 24
answer creep curve --a 6mm --b 4mm --load 80kN --mu 0.3
answer hunting geometry --wheel "$examples/hunting/worn-wheel.csv" --rail "$examples/hunting/new-rail.csv" --noise 0.003mm --end 3mm --step 0.1mm
answer hunting speed
answer hunting cycle --pair cn --speed 132ft/s --largest-amplitude 8mm
answer filters process sensors.csv --config "$examples/filters/car.toml"
answer psd classify track.csv
answer psd roughness track.csv
answer filters integrate "$examples/filters/axlebox.csv" --speed-column speed
answer quality index track.csv --speed 100km/h
answer quality limit --speed 100km/h
answer track joint --speed 60mph --dip 0.5in
answer track stiffness
answer wheelrail contact --load 50kN --speed 30m/s --method strips
figures=() # these draw none
[ "$FAIL_CALL" = fork ] && { echo "$runs runs" && exit $bad; }
answer creep history "$examples/creep/braking.csv" --a 6mm --b 4mm --load 80kN --mu 0.3 --cells 8
answer creep table --ratios 2 --longitudinal 4 --lateral 4 --spin 3 --points 10
answer quality measures track.csv
answer quality compare track.csv later.csv
answer wheelrail measure "$examples/hunting/worn-wheel.csv"
answer wheelrail table --from 0mm --to 2mm --shifts 2 --speed 30m/s --load 50kN --method strips
try - verify
try sensors-2.csv filters simulate --out sensors-2.csv --length 1000ft
try track-2.csv psd synthesize track-2.csv --length 1km --seed 1
echo "$runs runs"
exit $bad
