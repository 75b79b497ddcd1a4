#!/bin/sh
# page.sh SOURCE CHAPTER RAILBOOK SCRATCH: the commands of a chapter's section "Use it", as they stand there, and their answers.
# A block ```console of main.cpp holds lines "$ railbook ..." and what they answer; "..." stands for lines left out. The commands
# run in order in one folder, each with the files of tools/examples/SUBJECT beside it. Words are the same; numbers agree to the digits that are shown.
source=$1 chapter=$2 railbook=$3 scratch=$4
rm -rf "$scratch" && mkdir -p "$scratch" && cd "$scratch" || exit 1
awk '/^```console$/ { inside = 1; next } /^```$/ { inside = 0 } inside' "$source/chapters/$chapter/main.cpp" >page.txt
grep -c '^\$ railbook ' page.txt >/dev/null || { echo "$chapter: no command on the page" >&2; exit 1; }
awk '/^\$ railbook / { n++; file = sprintf("%02d", n); print substr($0, 12) > (file ".command"); printf "" > (file ".shown"); next }
     { print > (file ".shown") }' page.txt
status=0
for command in *.command; do
  name=${command%.command}
  echo "\$ railbook $(cat "$command")"
  examples=$source/tools/examples/$(cut -d' ' -f1 "$command")
  [ ! -d "$examples" ] || cp "$examples"/* . || exit 1
  eval "\"$railbook\" $(cat "$command")" >"$name.answer" 2>"$name.error" || { cat "$name.error" >&2; exit 1; }
  awk -v shown="$name.shown" '
    function digits(text) { sub(/[eE].*/, "", text); gsub(/[^0-9]/, "", text); sub(/^0+/, "", text); return length(text) }
    function is_number(text) { return text ~ /^[-+]?[0-9]*\.?[0-9]+([eE][-+]?[0-9]+)?$/ }
    function same(a, b, least, off, x, y) {
      if (a == b) return 1
      gsub(/[(),;]/, "", a); gsub(/[(),;]/, "", b)
      if (a == b) return 1
      if (!is_number(a) || !is_number(b)) return 0
      least = digits(a) < digits(b) ? digits(a) : digits(b)
      x = a + 0; y = b + 0; off = x > y ? x - y : y - x
      return off <= 10 ^ (1 - least) * (x < 0 ? -x : x)
    }
    function same_line(a, b, i, n, p, q) {
      n = split(a, p); if (n != split(b, q)) return 0
      for (i = 1; i <= n; i++) if (!same(p[i], q[i])) return 0
      return 1
    }
    { answer[++lines] = $0 }
    END {
      at = 1; gap = 0; bad = 0
      while ((getline line < shown) > 0) {
        if (line == "...") { gap = 1; continue }
        if (gap) while (at <= lines && !same_line(line, answer[at])) at++
        if (at > lines || !same_line(line, answer[at])) { print "not in the answer: " line; bad = 1; break }
        at++; gap = 0
      }
      exit bad
    }' "$name.answer" >"$name.difference" || { cat "$name.difference" >&2; echo "the answer is:" >&2; cat "$name.answer" >&2; status=1; }
done
exit $status
