#!/bin/sh
# readme.sh SOURCE RAILBOOK: the commands of the README's section on data of one's own, as they stand there.
source=$1 railbook=$2
folder=$(mktemp -d) || exit 1
trap 'rm -rf "$folder"' EXIT
mkdir -p "$folder/build/bin"
ln -s "$railbook" "$folder/build/bin/railbook"
ln -s "$source/tools" "$folder/tools"
cd "$folder" || exit 1
sed -n '/^## Your own data/,/^## How it is made/p' "$source/README.md" | sed -n 's/^    \(build\/bin\/railbook .*\)/\1/p' >commands
while IFS= read -r command <&3; do
  sh -c "$command" >said 2>&1 || { echo "status $?: $command"; tail -5 said; exit 1; }
done 3<commands
n=$(wc -l <commands)
echo "$n commands"
[ "$n" -ge 20 ]
