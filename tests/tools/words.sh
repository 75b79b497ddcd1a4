#!/bin/sh
# words.sh SOURCE: what a tool says of stability and convergence is read by a test: of each such text in the sources of the tools, a
# piece of two words or more with that word stands in a test. Not of the explanations of columns, and of what no input is known to cause.
cd "$1" || exit 1
exempt='where the motion grows|L_over_V|p\.stable|could not be followed from there|Carter.s row did not converge'
said='stable|neutral|converge|settle|certain|could not be followed|not located|stopped after|not found'
grep -rhoE "\"[^\"]*\\b(un)?($said)d?\\b[^\"]*\"" tools \
  --include='*.cpp' | grep -vE "$exempt" | sort -u | {
  missed=0
  while IFS= read -r text; do
    # Pieces between what is filled in; a word alone if it is the whole text.
    printf '%s\n' "$text" | sed 's/^"//; s/"$//; s/{[^}]*}\|[;()]/\n/g' | sed 's/^ *//; s/ *$//' | grep -E "$said" | grep -E '[a-z]+,? [a-z]+|^(un)?stable,?$' |
      grep -rqFf - --exclude=words.sh tests/tools || { echo "no test reads: $text"; missed=1; }
  done
  exit $missed
}
