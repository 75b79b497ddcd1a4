#!/bin/sh
# batch.sh RAILBOOK EXAMPLES: many records make one table, in one call or in several at once.
railbook=$1 examples=$2
folder=$(mktemp -d) || exit 1
trap 'rm -rf "$folder"' EXIT
cd "$folder" || exit 1
fail() { echo "$*"; exit 1; }
mkdir runs
for i in 1 2 3; do
  "$railbook" psd synthesize "runs/$i.csv" --length 5km --seed $i --roughness 5e-7m^2*cycle/m --corner 0.13cycle/m >/dev/null || fail "synthesize"
done
gzip -c runs/3.csv >"runs/it's \"5\", packed.csv.gz"
printf '# all runs\n1.csv\n2.csv\r\n3.csv\nit'"'"'s "5", packed.csv.gz\n' >runs/good.txt
echo "no record" >runs/bad.csv
{ cat runs/good.txt; printf 'bad.csv\nnone.csv\n'; } >runs/list.txt

classify() { "$railbook" psd classify --section 1km "$@"; }
classify --manifest runs/good.txt --out good >said || fail "many records: $(cat said)"
grep -q "answered *4 *$" said || fail "$(cat said)"
[ "$(ls good)" = "classify-table.csv
classify-table.jsonl" ] || fail "files: $(ls good)"
[ "$(grep -c ',record,' good/classify-table.csv)" = 4 ] || fail "rows of records"
[ "$(grep -c ',section,' good/classify-table.csv)" = 20 ] || fail "rows of sections"
grep -q '^"runs/it.s ""5"", packed.csv.gz",ok' good/classify-table.csv || fail "a hostile name"

# What is refused is a row with its reason, and the status says that not all were answered.
classify --manifest runs/list.txt --out whole >said 2>error
[ $? -eq 2 ] || fail "status of a table with refused records"
grep -q "WARNING: 2 of 6 records refused" said || fail "$(cat said)"
grep -q "2 of 6 records refused; the first: \"runs/bad.csv\"" error || fail "$(cat error)"
[ "$(grep -c ',record,' whole/classify-table.csv)" = 4 ] || fail "rows of records beside refused ones"
grep -q '^runs/none.csv,refused,.*cannot be read: No such file' whole/classify-table.csv || fail "the reason of a refusal"

# Without memory a record fails: the machine's fault, status 3.
(ulimit -v 16000; classify runs/1.csv runs/2.csv >/dev/null 2>error)
[ $? -eq 3 ] || fail "no memory: $(cat error)"

# JSON lines on standard output, and nothing else; several processes at once give the same rows.
classify --manifest runs/good.txt --json >lines || fail "json"
cmp lines good/classify-table.jsonl || fail "other lines than the table's"
cd runs || exit 1
split -n l/2 good.txt part- && ls part-* | xargs -P 2 -I{} sh -c '"$0" psd classify --section 1km --manifest {} --json >{}.jsonl' "$railbook" || fail "xargs"
cat part-*.jsonl | sed 's|"record":"|&runs/|' | cmp - ../lines || fail "xargs -P gives other rows: $(head -c 200 part-aa.jsonl)"
if parallel --version 2>/dev/null | grep -q GNU; then
  parallel --joblog log --pipe -N 2 -k "$railbook" psd classify --section 1km --manifest - --json <good.txt | sed 's|"record":"|&runs/|' | cmp - ../lines || fail "parallel gives other rows"
fi
cd ..
sh -n "$examples/psd/many.slurm" || fail "the job array"

# The same by the quality index and the measures; two columns of one file in one pass.
"$railbook" quality index runs/[123].csv --speed 100km/h --section 200m --out quality >said || fail "quality: $(cat said)"
[ "$(grep -c ',section,' quality/index-table.csv)" -ge 75 ] || fail "sections of quality"
"$railbook" quality measures runs/[123].csv --section 200m --out quality >said || fail "measures: $(cat said)"
awk -F, 'NR == 1 {print "distance_m,a_mm,b_mm"; next} {printf "%s,%s,%g\n", $1, $2, 2 * $2}' runs/2.csv >two.csv
"$railbook" psd classify two.csv --column a,3 --out two >said || fail "two columns: $(cat said)"
[ "$(grep -c ',record,' two/classify-table.csv)" = 2 ] || fail "two columns: $(cat two/classify-table.csv)"

# Two runs of one line: the second counts 3 m more, and half of it has grown by half.
awk -F, 'NR == 1 {print; next} {printf "%.4f,%.5f\n", $1 + 3, $2 * ($1 < 2500 ? 1 : 1.5)}' runs/3.csv >later.csv
"$railbook" quality compare runs/3.csv later.csv --out compared >said || fail "compare: $(cat said)"
awk -F, 'NR > 2 && $2 < 2400 && ($5 > 0.02 * $3 || $5 < -0.02 * $3 || $6 < 2.95 || $6 > 3.05) {exit 1}
  NR > 2 && $1 > 2600 && $2 < 4900 && ($5 < 0.45 * $3 || $5 > 0.55 * $3) {exit 1}' compared/compare.csv || fail "growth: $(cat compared/compare.csv)"
[ -s compared/compare.png ] || fail "no picture of the growth"
{ head -1 later.csv; tail -n +2 later.csv | tac; } >back.csv
"$railbook" quality compare runs/3.csv back.csv --json | grep -q '"offset_to_m": [23]\.' || fail "a run in the other direction"
"$railbook" quality compare runs/3.csv runs/2.csv >/dev/null 2>said && fail "two lines are taken for one"

# What is refused.
refused() {
  "$@" >/dev/null 2>said
  [ $? -eq 2 ] || fail "not refused: $*: $(cat said)"
}
refused "$railbook" psd classify runs/bad.csv runs/none.csv
refused "$railbook" psd classify runs/1.csv runs/1.csv
refused "$railbook" psd classify --manifest none.txt
refused "$railbook" psd classify
refused "$railbook" psd classify runs/1.csv runs/2.csv --figure x.png
: >whole/classify-table.csv && chmod 444 whole/classify-table.csv
refused classify --manifest runs/good.txt --out whole
exit 0
