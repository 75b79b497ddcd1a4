#!/bin/sh
# unconverged.sh RAILBOOK: what does not converge is said, and is no answer: status 1 (2 for bad input), nothing on standard output, no file.
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
# A load that no contact bears within the depth of half-spaces is bad input, which names what is allowed.
for method in hertz strips full; do
  "$railbook" wheelrail contact --load 80MN --speed 30m/s --method $method --out mine >said 2>error
  [ $? = 2 ] && [ ! -s said ] || fail "80 MN by $method: $(cat said error)"
  grep -q "^railbook: load is 8e+07 N; allowed (--load): up to [0-9.e+]* N, which" error || fail "$(cat error)"
done
# A row of a table says so, too, has no forces, and is counted; the row of a larger load is answered.
"$railbook" wheelrail table --from 8.5mm --to 8.5mm --shifts 1 --yaw-from -60mrad --yaw-to -60mrad --yaws 1 --mu 2 --load 500N --speed 10m/s --slip 0 \
  --method strips --json >row 2>error
[ $? = 2 ] || fail "a refused row leaves the status: $(cat row error)"
grep -q '"status":"refused","reason":"no depth up to 2 mm bears the load of 500 N .*","shift_mm"' row || fail "$(cat row)"
grep -q '"y_N"\|"normal_N"' row && fail "forces that did not converge: $(cat row)"
grep -q "1 of 1 records refused; the first: .*no depth up to 2 mm bears the load" error || fail "$(cat error)"
"$railbook" wheelrail table --from 0mm --to 0mm --shifts 1 --mu 0 --load 80MN 80kN --speed 10m/s --method hertz --out both >said 2>error
[ $? = 2 ] || fail "a refused row leaves the status: $(cat said error)"
grep -q "answered *0$" said && grep -q "refused *1$" said || fail "$(cat said)"
[ "$(sed 's/"[^"]*"//g' both/wheelrail-table.csv | cut -d, -f2,6 | xargs)" = "status,load_kN refused,80000 ok,80" ] || fail "$(cat both/wheelrail-table.csv)"
exit 0
