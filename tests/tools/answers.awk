# awk -f answers.awk EXPECTED FOUND: the lines of both are the same word by word, numbers to a hundredth or to 1e-6. With -v part=1 the
# lines expected need only be among those found, in their order. Exit status 1, with the first line that differs, if not.
function number(text) { return text ~ /^[-+]?([0-9]+\.?[0-9]*|\.[0-9]+)([eE][-+]?[0-9]+)?$/ }
function size(x) { return x < 0 ? -x : x }
function same_word(a, b) {
  gsub(/^\(|[),;]+$/, "", a)
  gsub(/^\(|[),;]+$/, "", b)
  if (a == b) return 1
  if (!number(a) || !number(b)) return 0
  return size(a - b) <= 1e-6 || size(a - b) <= 0.01 * (size(a) > size(b) ? size(a) : size(b))
}
function same(a, b, x, y, i, n) {
  n = split(a, x, /[ \t]+/)
  if (n != split(b, y, /[ \t]+/)) return 0
  for (i = 1; i <= n; i++) if (!same_word(x[i], y[i])) return 0
  return 1
}
FNR == 1 { file++ }
file == 1 { expected[++wanted] = $0 }
file == 2 { found[++seen] = $0 }
END {
  at = 1
  for (i = 1; i <= wanted; i++) {
    while (part && at <= seen && !same(expected[i], found[at])) at++
    if (at > seen || !same(expected[i], found[at])) {
      print "expected: " expected[i]
      if (!part) print "found:    " found[at]
      exit 1
    }
    at++
  }
  if (!part && seen > wanted) { print "found, not expected: " found[at]; exit 1 }
}
