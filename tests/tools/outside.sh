#!/bin/bash
# outside.sh CASE RAILBOOK TRACK: what the world outside does to the tools. TRACK is a record that `quality index` reads.
# Status 3, or the signal's; a reason; and neither results nor temporary files are left.
case=$1 railbook=$2 track=$3
folder=$(mktemp -d) || exit 77
trap 'rm -rf "$folder"' EXIT
mkdir "$folder/run" "$folder/tmp"
cd "$folder/run" || exit 77
export TMPDIR=$folder/tmp
bad() { echo "BAD: $1"; cat "$folder/said"; exit 1; }
expect() { [ "$status" = "$1" ] || bad "status $status, not $1"; }
says() { grep -q -e "$1" "$folder/said" || bad "does not say $1"; }
quiet() { [ -s "$folder/said" ] && bad "says something"; }
clean() { [ -z "$(ls -A "$folder/run" "$folder/tmp" | grep -v -e : -e '^$')" ] || bad "left $(ls -A "$folder/run" "$folder/tmp")"; }
limit=(quality limit --speed 100km/h)
fake() { # a gnuplot that runs $1
  printf '#!/bin/sh\n%s\n' "$1" >"$folder/gnuplot"
  chmod +x "$folder/gnuplot"
  export RAILBOOK_GNUPLOT=$folder/gnuplot
}
waits_for() { for _ in $(seq 600); do ls -A "$1" | grep -q "$2" && return; sleep 0.05; done; bad "never began"; }
case $case in
  "a full pipe")
    [ -c /dev/full ] || exit 77
    for arguments in "psd synthesize -" "psd synthesize /dev/stdout" "quality limit --speed 100km/h" "quality limit --speed 100km/h --out mine" "--help"; do
      "$railbook" $arguments >/dev/full 2>"$folder/said"
      status=$?
      expect 3; says "No space left on device"; clean
    done ;;
  "a closed standard output")
    "$railbook" "${limit[@]}" --out mine >&- 2>"$folder/said"
    status=$?
    expect 3; says "standard output"; clean ;;
  "a reader that goes away")
    { "$railbook" psd synthesize - --length 1000km 2>"$folder/said"; echo $? >"$folder/status"; } | head -n 2 >/dev/null
    status=$(cat "$folder/status")
    expect 141; quiet
    { (trap '' PIPE; exec "$railbook" psd synthesize - --length 1000km 2>"$folder/said"); echo $? >"$folder/status"; } | head -n 2 >/dev/null
    status=$(cat "$folder/status")
    expect 3; quiet; clean ;;
  "a size limit")
    for arguments in "psd synthesize big.csv --length 1000km" "quality index $track --column crosslevel --speed 100km/h --out mine"; do
      (ulimit -f 16; exec "$railbook" $arguments) >/dev/null 2>"$folder/said"
      status=$?
      expect 3; says "File too large"; clean
    done ;;
  "a disk that cannot be read")
    head -c 1 /proc/self/mem >/dev/null 2>&1 && exit 77
    [ -r /proc/self/mem ] || exit 77
    "$railbook" quality index /proc/self/mem --speed 100km/h >/dev/null 2>"$folder/said"
    status=$?
    expect 3; says "Input/output error"; clean ;;
  "an interrupt in mid-write")
    timeout --preserve-status -s INT 0.5 "$railbook" psd synthesize big.csv --length 200000km >/dev/null 2>"$folder/said"
    status=$?
    expect 130; clean ;;
  "an end in mid-write")
    "$railbook" psd synthesize big.csv --length 200000km >/dev/null 2>"$folder/said" &
    waits_for "$folder/run" part
    kill -TERM $!; wait $!
    status=$?
    expect 143; clean ;;
  "a kill in mid-write")
    # Nobody can clean up after it; but what stands under the name asked for is whole or not there, and the next run works.
    "$railbook" psd synthesize big.csv --length 200000km >/dev/null 2>"$folder/said" &
    waits_for "$folder/run" part
    kill -KILL $!
    wait $! 2>/dev/null
    [ -e big.csv ] && bad "a part stands under the name of the whole"
    "$railbook" psd synthesize big.csv --length 1km >/dev/null 2>"$folder/said"
    status=$?
    expect 0
    [ "$(wc -l <big.csv)" -gt 1000 ] || bad "the next run wrote $(wc -l <big.csv) lines" ;;
  "an interrupt while answers are written")
    fake 'echo $$ > "'$folder'/child"; sleep 600'
    timeout --preserve-status -s INT 0.5 "$railbook" "${limit[@]}" --out mine >/dev/null 2>"$folder/said" # to its whole group
    status=$?
    expect 130; clean ;;
  "a folder that is read-only")
    mkdir locked
    if [ "$(id -u)" = 0 ]; then # whom no permission stops
      unshare --mount sh -c 'mount -t tmpfs -o ro none .' 2>/dev/null || exit 77
      unshare --mount sh -c 'mount -t tmpfs -o ro none locked && shift && exec "$@"' sh x \
        "$railbook" "${limit[@]}" --out "$folder/run/locked/mine" >/dev/null 2>"$folder/said"
    else
      chmod a-w locked
      "$railbook" "${limit[@]}" --out locked/mine >/dev/null 2>"$folder/said"
    fi
    status=$?
    rmdir locked || bad "something was left in it"
    [ "$status" = 2 ] || [ "$status" = 3 ] || bad "status $status"
    says "cannot be\|Read-only\|Permission denied"; clean ;;
  "a folder that is not there")
    "$railbook" psd synthesize none/of/these/big.csv --length 1km >/dev/null 2>"$folder/said"
    status=$?
    [ "$status" = 2 ] || [ "$status" = 3 ] || bad "status $status"
    says "No such file or directory"; clean
    "$railbook" "${limit[@]}" --out none/of/these >/dev/null 2>"$folder/said" # which --out makes
    status=$?
    expect 0; [ -s none/of/these/limit.json ] || bad "no answer" ;;
  "another folder, language and time zone")
    answer() { "$railbook" quality index "$track" --column crosslevel --speed 100km/h --json 2>"$folder/said" | grep -v -e '"out"' -e seconds; }
    plain=$(answer)
    [ -n "$plain" ] || bad "no answer"
    for setting in LC_ALL=de_DE.UTF-8 LC_ALL=tr_TR.UTF-8 LC_ALL=C LC_ALL=none LANG=fr_FR.ISO-8859-1 TZ=Pacific/Kiritimati TZ=none HOME=/nowhere COLUMNS=1 TERM=dumb; do
      [ "$(env "$setting" bash -c '"$@"' x "$railbook" quality index "$track" --column crosslevel --speed 100km/h --json 2>"$folder/said" | grep -v -e '"out"' -e seconds)" = "$plain" ] || bad "another answer with $setting"
    done
    cd / || exit 1
    [ "$(answer)" = "$plain" ] || bad "another answer in /"
    mkdir "$folder/gone" && cd "$folder/gone" && rmdir "$folder/gone"
    [ "$(answer)" = "$plain" ] || bad "another answer in a folder that has been removed"
    cd "$folder/run" || exit 1
    clean ;;
  "an end while gnuplot draws")
    fake 'cd "'$folder'" && echo $$ >pid && mv pid child; sleep 600 & sleep 600' # the number is there when the file is
    "$railbook" "${limit[@]}" --out mine >/dev/null 2>"$folder/said" &
    tool=$!
    waits_for "$folder" child
    kill -TERM $tool; wait $tool
    status=$?
    expect 143; clean
    draws() { ps -e -o pgid=,stat= | grep -q "^ *$(cat "$folder/child") [^Z]"; }
    for _ in $(seq 50); do draws || break; sleep 0.1; done
    draws && bad "gnuplot still runs"
    true ;;
  "a FIFO of options")
    mkfifo options
    printf 'speed = "100km/h"\n' >options &
    "$railbook" quality limit --config options --out mine >/dev/null 2>"$folder/said"
    status=$?
    rm -f options
    expect 0; [ -s mine/limit.json ] || bad "no answer" ;;
  "a FIFO that nobody writes to")
    mkfifo "$folder/silent"
    timeout 30 "$railbook" quality limit --config "$folder/silent" >/dev/null 2>"$folder/said"
    status=$?
    expect 2; says "nobody writes to" ;;
  "a disk that is full")
    unshare --user --map-root-user --mount sh -c 'mount -t tmpfs -o size=100k none .' 2>/dev/null || exit 77
    for size in 4 8 16 40; do
      unshare --user --map-root-user --mount sh -c 'mount -t tmpfs -o size=$1k none . && cd . && shift && exec "$@"' sh $size \
        "$railbook" quality index "$track" --column crosslevel --speed 100km/h --out "$folder/run/mine" >"$folder/said" 2>&1
      status=$?
      expect 3; says "No space left on device"; clean
    done ;;
  "a gnuplot that hangs")
    fake 'sleep 600'
    export RAILBOOK_GNUPLOT_SECONDS=1
    "$railbook" "${limit[@]}" --out mine >/dev/null 2>"$folder/said"
    status=$?
    expect 3; says "was ended after 1 s"; clean ;;
  "a gnuplot that fails")
    fake 'echo no fonts >&2; exit 4'
    "$railbook" "${limit[@]}" --out mine >/dev/null 2>"$folder/said"
    status=$?
    expect 3; says "exit status 4"; says "no fonts"; clean ;;
  "no gnuplot")
    RAILBOOK_GNUPLOT=$folder/none "$railbook" "${limit[@]}" --out mine >/dev/null 2>"$folder/said"
    status=$?
    expect 3; says "cannot run"; clean ;;
  "a folder for temporary files that is not there")
    TMPDIR=$folder/none "$railbook" "${limit[@]}" --out mine >/dev/null 2>"$folder/said"
    status=$?
    expect 3; says "No such file or directory"; clean ;;
  *) exit 1 ;;
esac
