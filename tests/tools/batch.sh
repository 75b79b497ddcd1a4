#!/bin/sh
# batch.sh RAILBOOK: many records make one table, by several processes or shards, taken up again where a run was ended.
railbook=$1
folder=$(mktemp -d) || exit 1
trap 'rm -rf "$folder"' EXIT
cd "$folder" || exit 1
fail() { echo "$*"; exit 1; }
mkdir runs
for i in 1 2 3 4 5; do
  "$railbook" psd synthesize "runs/$i.csv" --length 5km --seed $i --roughness 5e-7m^2*cycle/m --corner 0.13cycle/m >/dev/null || fail "synthesize"
done
echo "no record" >runs/bad.csv
gzip -c runs/5.csv >"runs/it's \"5\", packed.csv.gz"
printf '# all runs\n1.csv\n2.csv\n3.csv\n4.csv\r\n5.csv\nbad.csv\nnone.csv\nit'"'"'s "5", packed.csv.gz\n' >runs/list.txt

classify() { "$railbook" psd classify --manifest runs/list.txt --section 1km "$@"; }
classify --out whole --jobs 2 >said || fail "many records: $(cat said)"
grep -q "answered *6 *$" said && grep -q "DOUBTFUL: 2 of 8 records refused" said || fail "$(cat said)"
[ "$(ls whole)" = "classify-table.csv
classify-table.jsonl" ] || fail "files: $(ls whole)"
[ "$(grep -c ',record,' whole/classify-table.csv)" = 6 ] || fail "rows of records"
[ "$(grep -c ',section,' whole/classify-table.csv)" = 30 ] || fail "rows of sections: $(grep -c ',section,' whole/classify-table.csv)"
grep -q '^runs/none.csv,refused,.*cannot be read: No such file' whole/classify-table.csv || fail "the reason of a refusal"
grep -q '^"runs/it.s ""5"", packed.csv.gz",ok' whole/classify-table.csv || fail "a hostile name"

# A rerun finds all done; a changed record is done again; other options are another table.
classify --out whole >said && grep -q "done in an earlier run *8" said || fail "rerun: $(cat said)"
cp whole/classify-table.csv before.csv
"$railbook" psd synthesize runs/1.csv --length 6km --seed 9 --roughness 5e-7m^2*cycle/m >/dev/null
classify --out whole >said && grep -q "done in an earlier run *7" said || fail "a changed record: $(cat said)"
cmp -s whole/classify-table.csv before.csv && fail "a changed record is not answered anew"
classify --out whole --window hamming >said && grep -q "done in an earlier run *0" said || fail "other options: $(cat said)"

# Shards, one of them ended in the middle of a line, merge to the same table.
classify --out plain --jobs 1 >/dev/null || fail "one process"
for i in 1 2 3; do classify --out shards --shard $i/3 >/dev/null || fail "shard $i"; done
[ "$(cat shards/classify-*-of-3.jsonl | wc -l)" = "$(cat plain/classify-table.jsonl | wc -l)" ] || fail "shards hold something twice, or not"
tail -c 100 shards/classify-2-of-3.jsonl >tail && truncate -s -100 shards/classify-2-of-3.jsonl
classify --out shards >said || fail "merging"
grep -q "done in an earlier run *7" said || fail "merging: $(cat said)"
cmp shards/classify-table.csv plain/classify-table.csv || fail "shards make another table"
cmp shards/classify-table.jsonl plain/classify-table.jsonl || fail "shards make other lines"

# Ended by a signal, and taken up again.
classify --out ended --jobs 1 >/dev/null 2>&1 &
run=$!
for i in 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19 20; do
  [ -s ended/classify-begun.jsonl ] && break
  sleep 0.1
done
kill -9 $run 2>/dev/null
wait $run 2>/dev/null
classify --out ended >said || fail "after a kill"
cmp ended/classify-table.csv plain/classify-table.csv || fail "after a kill the table is another"

# JSON lines on standard output, and nothing else.
classify --json >lines || fail "json"
[ "$(grep -c '^{"record":' lines)" = "$(wc -l <lines)" ] || fail "not only JSON: $(grep -v '^{"record":' lines | head -3)"

# The same by the quality index and the measures; two columns of one file in one pass.
"$railbook" quality index runs/*.csv --speed 100km/h --section 200m --out quality >said || fail "quality: $(cat said)"
[ "$(grep -c ',section,' quality/index-table.csv)" -ge 125 ] || fail "sections of quality"
"$railbook" quality measures runs/*.csv --section 200m --out quality >said || fail "measures: $(cat said)"
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
"$railbook" quality compare runs/3.csv runs/4.csv >/dev/null 2>said && fail "two lines are taken for one"

# What is refused.
refused() {
  "$@" >/dev/null 2>said
  [ $? -eq 2 ] || fail "not refused: $*: $(cat said)"
}
refused classify --out x --shard 4/3
refused classify --out x --shard a/3
refused classify --shard 1/3
refused "$railbook" psd classify runs/bad.csv runs/none.csv
refused "$railbook" psd classify runs/1.csv runs/1.csv
refused "$railbook" psd classify --manifest none.txt
refused "$railbook" psd classify
refused "$railbook" psd classify runs/1.csv runs/2.csv --figure x.png
: >whole/classify-table.csv && chmod 444 whole/classify-table.csv
refused classify --out whole
exit 0
