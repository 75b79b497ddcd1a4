#!/bin/sh
# readme.sh SOURCE RAILBOOK: the commands of the README with the answers that it shows, and those of docs/own-data.md and
# docs/many-records.md. In the README a command stands after "$ " in a block, and below it lines of its answer.
source=$1 railbook=$2
folder=$(mktemp -d) || exit 1
trap 'rm -rf "$folder"' EXIT
mkdir -p "$folder/bin" "$folder/build/bin"
ln -s "$railbook" "$folder/bin/railbook"
ln -s "$railbook" "$folder/build/bin/railbook"
ln -s "$source/tools" "$folder/tools"
ln -s "$source/tools/examples" "$folder/examples"
PATH=$folder/bin:$PATH
cd "$folder" || exit 1

# The README: answers 1, 2 ... and the command of each.
awk '/^    \$ / { n++; print substr($0, 7) > ("command-" n); close("command-" n); inside = 1; next }
     /^    / && inside { if ($1 != "...") print substr($0, 5) > ("expected-" n); next }
     { inside = 0 }' "$source/README.md"
shown=0
while [ -f "command-$((shown + 1))" ]; do
  shown=$((shown + 1))
  sh "command-$shown" >said 2>&1 || { echo "status $?: $(cat "command-$shown")"; tail -5 said; exit 1; }
  [ -s "expected-$shown" ] || continue
  awk -v part=1 -f "$source/tests/tools/answers.awk" "expected-$shown" said || { echo "README.md: another answer of $(cat "command-$shown")"; exit 1; }
done
echo "$shown commands with answers"
[ "$shown" -ge 3 ] || exit 1

sed -n 's/^    \(railbook .*\)/\1/p' "$source/docs/own-data.md" "$source/docs/many-records.md" >commands
while IFS= read -r command <&3; do
  sh -c "$command" >said 2>&1 || { echo "status $?: $command"; tail -5 said; exit 1; }
done 3<commands
n=$(wc -l <commands)
echo "$n commands"
[ "$n" -ge 15 ]
