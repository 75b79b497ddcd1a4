#!/bin/bash
# names.sh KIND PROGRAM ARGUMENTS...: hostile names are names. The tool runs once for each, in a folder of its own, with
# the name as that of --out (KIND out), of the file it writes (KIND file), or of the file
# @ and its --out (KIND in, where @ is replaced by a copy of RECORD). Each time it must end with 0 and leave its files
# under that very name, or with 2 and a message; and nothing else may appear.
kind=$1 program=$2 verb=$4
shift 2
folder=$(mktemp -d) || exit 77
trap 'rm -rf "$folder"' EXIT
failed=0
bad() { printf 'BAD %q: %s\n' "$name" "$1"; cat "$folder/said"; failed=1; }
names=('<touch p;echo ' '|touch p;cat ' "x';touch p;'" '"; touch p; echo "' '$HOME$(touch p)`touch p`'
       "it's mine" $'line\nbreak' '-rf' '--help' 'Gleis über Öl' '*' '~' '%s%n' '_{a}' '@COLUMNHEAD-1@' ' ')
# One tool meets them all, from a file of options as well; the others, which write by the same code, those that run a command. It draws
# where gnuplot, or a shell, could take the name for more than a name.
[ "$verb" = limit ] || names=("${names[@]:0:5}")
plain=()
[ "$verb" = limit ] && plain=(--no-figures)
run() { # run FILE-OR-FOLDER ARGUMENTS...: in an empty folder
  made=$1
  shift
  "$program" "$@" >"$folder/said" 2>&1 </dev/null
  status=$?
  [ -e p ] && bad "ran a command"
  if [ $status = 0 ]; then
    [ -e "./$made" ] || bad "ended with 0 and made nothing of that name"
    [ "$(find . -mindepth 1 -maxdepth 1 ! -name given.toml ! -name in -printf x)" = x ] || bad "made something else: $(ls -A)"
  elif [ $status != 2 ] || ! [ -s "$folder/said" ]; then
    bad "ended with $status"
  elif [ -e "./$made" ]; then
    bad "refused, and left something"
  fi
}
fresh() { rm -rf "$folder/run"; mkdir "$folder/run"; cd "$folder/run" || exit 1; }
for name in "${names[@]}"; do
  case $kind in
    out)
      drawn=("${plain[@]}")
      [[ $name == *[\`\%_@\"]* || $name == *p* ]] && drawn=()
      fresh; run "$name" "$@" "${drawn[@]}" "--out=$name"
      [ $status = 0 ] || bad "was refused"
      [ "$verb" = limit ] || continue
      [[ $name == *\"* || $name == *\' || $name == *$'\n'* ]] && continue # a file of options cannot hold them
      fresh; printf 'out = "%s"\n' "$name" >given.toml; run "$name" "$@" "${plain[@]}" --config given.toml
      [ $status = 0 ] || bad "was refused"
      ;;
    file) fresh; run "$name" "$@" -- "$name" ;;
    in)
      fresh; mkdir in; cp "$RECORD" "in/$name" || exit 1
      arguments=()
      for argument; do arguments+=("${argument//@/in/$name}"); done
      run "$name" "${arguments[@]}" "--out=$name"
      [ $status = 0 ] || bad "was refused"
      ;;
  esac
done
exit $failed
