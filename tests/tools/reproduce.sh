#!/bin/bash
# reproduce.sh PROGRAM NN-NAME ITEM: `reproduce --out` writes under the very name given, runs nothing, replaces only what
# runs made, and leaves no record that looks good when it is killed. ITEM is a figure.
program=$1 chapter=$2 item=$3
folder=$(mktemp -d) || exit 77
trap 'rm -rf "$folder"' EXIT
cd "$folder" || exit 77
mkdir run tmp
export TMPDIR=$folder/tmp
bad() { echo "BAD: $1"; cat "$folder/said"; exit 1; }
reproduce() { "$program" reproduce --only "$item" --no-timings "--out=$1" >"$folder/said" 2>&1 </dev/null; }
cd run || exit 77
for name in '<touch p;echo ' '|touch p;cat ' "x';touch p;'" '"; touch p; echo "' '$HOME' "it's mine" $'line\nbreak' '-rf' 'Öl'; do
  reproduce "$name" || bad "failed on $name"
  [ -s "./$name/figures/$chapter/$item.png" ] || bad "no figure under $name"
  [ "$(find . -mindepth 1 -maxdepth 1 -printf x)" = x ] || bad "made something else of $name"
  rm -rf -- "./$name"
done
reproduce out || bad "failed"
reproduce out || bad "failed the second time"
echo mine >"out/figures/$chapter/mine.png"
reproduce out
[ $? = 2 ] || bad "took a folder with a file of the user"
grep -q mine.png "$folder/said" || bad "does not name it"
[ "$(cat "out/figures/$chapter/mine.png")" = mine ] || bad "replaced it"
rm "out/figures/$chapter/mine.png"
mkdir -p "golden/figures/$chapter" && echo golden >"golden/figures/$chapter/$item.png"
reproduce golden
[ $? = 2 ] && [ "$(cat "golden/figures/$chapter/$item.png")" = golden ] || bad "replaced a golden figure"
reproduce ''
[ $? = 2 ] || bad "took no name for a folder"
printf '#!/bin/sh\necho $$ > "%s/child"\nexec sleep 600\n' "$folder" >"$folder/gnuplot"
chmod +x "$folder/gnuplot"
RAILBOOK_GNUPLOT=$folder/gnuplot RAILBOOK_GNUPLOT_SECONDS=60 "$program" reproduce --only "$item" --out out >"$folder/said" 2>&1 &
run=$!
for _ in $(seq 1200); do [ -e "$folder/child" ] && break; sleep 0.05; done
kill -KILL $run
wait $run 2>/dev/null
sleep 0.1
kill -KILL "$(cat "$folder/child")" # nobody else could
[ -e "out/results/$chapter.json" ] && bad "left the old record"
[ -e "out/results/$chapter.txt" ] && bad "left the old summary"
reproduce out || bad "does not recover"
RAILBOOK_GNUPLOT=$folder/gnuplot RAILBOOK_GNUPLOT_SECONDS=1 reproduce out
[ $? = 3 ] || bad "a gnuplot that hangs is no status 3"
grep -q "was ended after 1 s" "$folder/said" || bad "does not say so"
"$program" reproduce --only "$item" --no-timings --out out >/dev/full 2>"$folder/said"
[ $? = 3 ] || bad "was content with a full pipe"
# A disk that is full inside one item, tried on a small file system of one's own.
small() { # small KIB: reproduce on a file system of that size
  unshare --user --map-root-user --mount sh -c 'mount -t tmpfs -o size=$1k none out && shift && exec "$@"' sh "$1" \
    "$program" reproduce --only "$item" --no-timings --out out >"$folder/said" 2>&1
}
if unshare --user --map-root-user --mount sh -c 'mount -t tmpfs -o size=100k none out' 2>/dev/null; then
  for size in 4 8 16; do
    small $size
    status=$?
    [ $status = 3 ] || bad "a disk of $size KiB: status $status"
    grep -q "No space left on device" "$folder/said" || bad "a disk of $size KiB: no reason"
  done
  small 8000 || bad "fails on a small disk that is large enough"
fi
exit 0
