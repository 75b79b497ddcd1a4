#!/bin/sh
# commands.sh SOURCE RAILBOOK [--accept]: the examples of docs/commands.txt, run. Holds docs/commands.md to what the command answers
# (numbers to a hundredth, which processors and compilers share) and its pictures to be drawn; with --accept writes both.
source=$1 railbook=$2 accept=$3
compare=$source/tests/tools/answers.awk
folder=$(mktemp -d) || exit 1
trap 'rm -rf "$folder"' EXIT
mkdir "$folder/bin" "$folder/pictures"
ln -s "$railbook" "$folder/bin/railbook"
ln -s "$source/tools/examples" "$folder/examples"
PATH=$folder/bin:$PATH
cd "$folder" || exit 1

failed=0 before='' n=0
exec 4>commands.md
printf '%s\n' '<!-- Made by `make accept-commands` from docs/commands.txt; tests/tools/commands.sh holds it to what the command answers. -->' >&4
while IFS='|' read -r name question command picture <&3; do
  case $name in '#'* | '') continue ;; esac
  name=$(echo $name) question=$(echo $question) picture=$(echo $picture)
  command=$(printf '%s\n' "$command" | sed 's/^ *//; s/ *$//')
  subject=${name% *} id=$(echo "$name" | tr ' ' -)
  if [ "$subject" != "$before" ]; then
    printf '\n## %s: %s\n' "$subject" "$(railbook "$subject" --help | head -n 1)" >&4
    before=$subject
  fi
  sh -c "$command" >answer 2>errors || { echo "status $?: $command"; tail -n 5 answer errors; exit 1; } # a slow machine reports progress there
  printf '\n### railbook %s\n\n%s\n\n```sh\n%s\n```\n\n```answer\n' "$name" "$question" "$command" >&4
  sed 's/ *$//' answer >&4
  printf '```\n' >&4
  if [ -n "$picture" ]; then
    sh -c "$command --figure pictures/$id.svg" >/dev/null 2>drawing || { cat drawing; exit 1; }
    printf '\n![%s](pictures/%s.svg)\n' "$picture" "$id" >&4
    [ -n "$accept" ] || [ -s "$source/docs/pictures/$id.svg" ] || { echo "docs/pictures/$id.svg is not there"; failed=1; }
  fi
  n=$((n + 1))
done 3<"$source/docs/commands.txt"
exec 4>&-

# Every command that there is has its example.
for subject in $(railbook --help | sed -n '/^Subcommands/,/^$/s/^  \([a-z]*\) .*/\1/p'); do
  for verb in $(railbook "$subject" --help | sed -n '/^Subcommands/,/^$/s/^  \([a-z]*\) .*/\1/p'); do
    grep -q "^### railbook $subject $verb\$" commands.md || { echo "docs/commands.txt has no example of railbook $subject $verb"; failed=1; }
  done
done

if [ -n "$accept" ]; then
  cp commands.md "$source/docs/commands.md" && rm -f "$source"/docs/pictures/*.svg && cp pictures/*.svg "$source/docs/pictures" || exit 1
elif ! awk -f "$compare" "$source/docs/commands.md" commands.md; then
  echo "docs/commands.md is not what the command answers: make accept-commands"
  failed=1
fi
echo "$n commands"
[ "$n" -gt 0 ] || failed=1
exit $failed
