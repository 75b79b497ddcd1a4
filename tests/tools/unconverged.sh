#!/bin/sh
# unconverged.sh RAILBOOK: what does not converge is said, and is no answer: status 1, nothing on standard output, no file.
railbook=$1
folder=$(mktemp -d) || exit 1
trap 'rm -rf "$folder"' EXIT
cd "$folder" || exit 1
fail() { echo "$*"; exit 1; }
# no_answer REASON arguments...
no_answer() {
  reason=$1
  shift
  "$railbook" "$@" --out mine >said 2>error
  status=$?
  [ $status = 1 ] || fail "status $status: $*"
  [ ! -s said ] || fail "an answer that did not converge: $(head -3 said)"
  [ -z "$(ls -A mine 2>/dev/null)" ] || fail "files of an answer that did not converge: $(ls -A mine)"
  grep -q "^railbook: no answer.*$reason" error || fail "$(cat error)"
}
# A friction that holds a wheel up on its flange: no depth bears the load.
climbing="--yaw -60mrad --mu 2 --load 500N --speed 10m/s --slip 0"
for method in strips full; do
  # shellcheck disable=SC2086 # options
  no_answer "no depth up to 2 mm bears the load" wheelrail contact --shift 8.5mm --roll 0rad $climbing --method $method
done
# A row of a table says so, too, and has no forces.
"$railbook" wheelrail table --from 8.5mm --to 8.5mm --shifts 1 --yaw-from -60mrad --yaw-to -60mrad --yaws 1 --mu 2 --load 500N --speed 10m/s --slip 0 \
  --method strips --json >row || fail "no row: $(cat row)"
grep -q '"refused":"no depth up to 2 mm bears the load","warnings":"refused"' row || fail "$(cat row)"
grep -q '"y_N"\|"normal_N"' row && fail "forces that did not converge: $(cat row)"
exit 0
