# Sourced by tables.sh.
# 4 mm of a wave of 6 m, and waves of 1 m and 60 m: the band of 3 to 25 m has the first alone.
awk 'BEGIN {print "distance_m,profile_mm"; for (i = 0; i < 12000; ++i) {w = 2 * 3.14159265358979 * i / 4
  printf "%.2f,%.4f\n", i / 4, 4 * sin(w / 6) + 2 * sin(w) + 6 * sin(w / 60) + 0.1 * sin(i * i)}}' >waves.csv
answers rms classify waves.csv --reference fra-5
near "rms of waves of 3 to 25 m" "$(v rms rms_3_25_mm)" 2.83 0.05
# Tracks to order without roughness, by hand: dips of half the printed B, the wave that the ballast remembers of other rails, a long wave, a grade, noise, gaps.
# shellcheck disable=SC2086 # options
made() { "$railbook" psd synthesize made.csv --length "$1" --spacing 25cm --roughness 0m --json $2 >made.json || fail "$*"; } # made LENGTH OPTIONS
pi=3.14159265358979
made 2000.2m "--dip 10mm --rail 12m"
holds "dips" made.csv '{s = sin(pi * $1 / 12); near($1, (rows - 1) / 4, 1e-9); near($2, -5 * (1 - abs(s)), 1e-9)} END {near(rows, 8000, 0)}' pi=$pi
means made 'is("samples", 8000); is("length_km", 2); is("seed", 1)'
made 2000.2m "--memory 10mm --old-rail 10m --seed 7"
holds "remembered rails" made.csv '{near($2, -20 / (3 * pi) * cos(2 * pi * $1 / 10), 1e-9)}' pi=$pi
near "the seed" "$(v made seed)" 7 0
made 2000.2m "--wave 10mm --wave-length 100m --grade 0.001"
holds "a wave on a grade" made.csv '{near($2, 10 * sin(2 * pi * $1 / 100) + $1, 1e-8)}' pi=$pi
made 20km "--noise 1mm --gaps 10%"
holds "noise and gaps" made.csv '$2 == "nan" {++lost; next} {sum += $2; squares += $2 ^ 2; ++n} END {near(sum / n, 0, 0.02); near(squares / n, 1, 0.03); near(lost / rows, 0.1, 0.02); near(rows, 80000, 0)}'
# Dips that scatter do so about their mean, and are correlated from joint to joint as asked; modulated dips swing at the difference of both rails.
made 24km "--dip 10mm --rail 12m --scatter 0.2 --correlation 0.8"
holds "scattered dips" made.csv 'NR > 1 && $1 % 12 == 0 {++n; d = -$2 / 5 - 1; sum += d; squares += d ^ 2; if (n > 1) products += d * before; before = d} END {near(sum / n, 0, 0.05); near((squares / n) ^ 0.5, 0.2, 0.03); near(products / squares, 0.8, 0.08); near(n, 2000, 0)}'
made 2000.2m "--dip 10mm --rail 12m --modulation 0.5 --old-rail 10m"
holds "modulated dips" made.csv '$1 % 12 == 0 {near($2, -5 * (1 + 0.5 * cos(2 * pi * $1 / 60)), 1e-6); ++n} END {near(n, 167, 0)}' pi=$pi
# The answer and its files: A over phi^2, the boundary of each class as an ellipse of dips and roughness, the point, the limits of 49 CFR 213.63 and ours of class 6.
"$railbook" psd synthesize zone.csv --length 12km --spacing 25cm --roughness 5e-7m^2*cycle/m --corner 0.13cycle/m --dip 11mm >/dev/null || fail "synthesize"
draws zone classify zone.csv --reference fra-5,german-low
means zone 'is("length_km", 12); says("length_km", "48000 samples, 0 missing, 0 bridged"); is("spacing_m", 0.25); is("missing", 0); is("bridged", 0); is("faulty", 0); is("segment_m", 1024); says("segment_m", "4096 samples")
  used = (v["segments"] + 1) * 2048; is("segments", 22); says("segments", sprintf("%d samples in none", 48000 - used)); is("A", 5e-7, 0.1); is("A_error", v["A"] / 30, 0.3); is("phi_c", 0.13, 0.1); free("phi_c_error")
  is("rail_m", 39 * 0.3048); is("B_printed_mm", 11, 0.15); is("B_exact_mm", v["B_printed_mm"] / 2); is("B_exact_mm_error", v["B_printed_mm_error"] / 2); is("B_printed_mm_error", 0.5, 0.3)
  free("C_1 beta scatter_note"); d = v["deviation_mm"]; is("deviation_mm", d); split("76.2 69.85 57.15 50.8 31.75 12.7", limit, " "); class = odds = 0
  for (k = 1; k <= 6; ++k) {is("limit_" k "_mm", limit[k]); says("limit_" k "_mm", sprintf("d is %.0f %% of it", 100 * d / limit[k])); if (d <= limit[k]) class = k; odds += v["odds_" k]; free("odds_" k)}
  is("class", class); says("class", sprintf("margin %.1f %%", 100 * (1 - d / limit[class]))); if (abs(odds - 1) > 3e-4) bad("odds " odds); if (v["odds_" class] < 0.5) bad("odds of the class")
  split(notes["deviation_mm"], part, /[ ,]+/); v["both"] = part[2] ^ 2 + part[4] ^ 2; is("both", d ^ 2, 0.01)
  is("rms_3_25_mm", rms, 0.01); is("rms_fra-5_mm", fra, 0.03); is("rms_german-low_mm", german, 0.03); says("rms_german-low_mm", "the record is worse"); says("rms_fra-5_mm", rms < fra ? "better" : "worse")' \
  rms="$(awk -F, 'NR > 1 && $1 >= 0.04 && $1 <= 1 / 3 {sum += $2} END {printf "%.9g", 1e3 * sqrt(sum / 1024)}' zone/spectrum.csv)" \
  $(awk -F, '/^phi/ {name = $3; before = 0; next} NF == 3 {if (before >= 0.04 && $1 <= 1 / 3) sum[name] += ($1 - before) * ($2 + last) / 2; before = $1; last = $2} END {printf "fra=%.9g german=%.9g", 1e3 * sqrt(sum["fra-5"]), 1e3 * sqrt(sum["german-low"])}' zone.drawn/1/d2.csv)
# gnuplot tells blocks by two blank lines.
awk 'NF == 0 {++blank; next} /^phi/ && NR > 1 {if (blank != 2) exit 1; ++n} {blank = 0} END {exit n != 1}' zone.drawn/1/d2.csv || fail "one block of the references"
[ "$(awk -F, '/^phi/ {if (NR > 1) print last; next} NF > 1 {last = $1} END {print last}' zone.drawn/1/d2.csv | xargs)" = "0.666667 1" ] || fail "where the references end"
holds "the spectrum" zone/spectrum.csv '{near($1 * 1024, rows, 1e-4 * rows); near($4 * $1 ^ 2 / A, 1, 1e-4)} END {near(rows, 2048, 0)}' A="$(v zone A)"
holds "the classes" zone/classes.csv 'NF < 3 {--rows; next} $1 != class {if (class != "") near(j, 200, 0); class = $1; j = 0; A = $3; if (class == 1) first = A; split("76.2 69.85 57.15 50.8 31.75 12.7", D, " "); near(A / first, (D[class] / D[1]) ^ 2, 1e-4)}
  {s = sin(pi / 400 * j++); near($3 / A, 1 - s ^ 2, 1e-4); if (j == 101) near($2 / D[class], scale == "" ? $2 / D[class] : scale, 1e-4); if (j == 101) scale = $2 / D[class]} END {near(rows, 1200, 0)}' pi=$pi
# A record on the boundary by both: its class is the one whose ellipse it is within.
holds "the point" zone/point.csv '{near($1, b, 1e-9); near($2, be, 1e-9); near($3 / a, 1, 1e-9); near($4 / ae, 1, 1e-9)}' b="$(v zone B_printed_mm)" be="$(v zone B_printed_mm_error)" a="$(v zone A)" ae="$(v zone A_error)"
# A chord is taken out where it sees, and a line is broken where it does not.
draws chord classify zone.csv --chord 62ft --reference fra-5
awk -F, 'NR == FNR {if (NF == 4) full[$1] = $2; next} NF == 4 && FNR > 1 {g = 4 * sin(3.14159265358979 * $1 * 62 * 0.3048 / 2) ^ 4; r = $2 * g / full[$1]; if (g < 0.001 || r < 0.99 || r > 1.01) {print $0, g, r; exit 1}; ++n}
  NF == 0 {++breaks} END {if (!(n > 1000 && breaks > 10)) exit 1}' zone/spectrum.csv chord/spectrum.csv || fail "the gain of a chord"
# Long segments where there is enough, shorter ones else; half a section at the end is one, less is none.
for record in "0.25 12000 1024" "1 12000 1024" "3 12000 1536" "0.25 1800 512" "0.25 1000 256" "0.25 500 128"; do
  # shellcheck disable=SC2086 # spacing, length, segment
  set -- $record
  "$railbook" psd synthesize short.csv --length "$2m" --spacing "$1m" --roughness 5e-7m^2*cycle/m --corner 0.13cycle/m >/dev/null || fail "synthesize"
  answers short classify short.csv
  near "the segment of $2 m" "$(v short segment_m)" "$3" 1e-6
  if [ "$3" -lt 1024 ]; then grep -q segment_note short.json || fail "no word of shorter segments"; else grep -q segment_note short.json && fail "shorter segments"; fi
done
for rest in 400:5 600:6; do
  head -$((20002 + 4 * ${rest%:*})) zone.csv >part.csv
  "$railbook" psd classify part.csv --section 1km --no-figures --out parts-${rest%:*} >said || fail "$(cat said)"
  holds "sections" parts-${rest%:*}/classify-table.csv '$c["kind"] == "section" {near($c["from_m"], 1000 * n++, 0.3); near($c["samples"], n < 6 ? 4000 : 2400, 1); near($c["to_m"] - $c["from_m"], $c["samples"] / 4, 0.3); near($c["missing"], 0, 0); near($c["rail_m"], 11.8872, 1e-6)}
    $c["kind"] == "record" {near($c["segment_m"], 1024, 0); near($c["segments"] > 3, 1, 0)} END {near(n, sections, 0)}' sections=${rest#*:}
done
for spacing in 47.5m 48m; do
  "$railbook" psd classify zone.csv --section $spacing --no-figures --out parts-$spacing >said 2>&1
  status=$?
  [ $spacing = 48m ] && want=0 || want=2
  [ $status = $want ] || fail "sections of $spacing: status $status: $(cat said)"
done
# What the answer of one record says, its row among many says too.
cp zone.csv zone2.csv
"$railbook" psd classify zone.csv zone2.csv --no-figures --out many >said || fail "$(cat said)"
holds "a row of many" many/classify-table.csv '{near($c["A_m2_cycle_per_m"] / A, 1, 1e-6); near($c["A_error"] / Ae, 1, 1e-6); near($c["phi_c_cycle_per_m"], phi, 1e-6); near($c["B_printed_mm"], B, 1e-6); near($c["B_printed_error_mm"], Be, 1e-6); near($c["rail_m"], 11.8872, 1e-6)
  near($c["deviation_mm"], d, 1e-6); near($c["class"], 5, 0); near($c["odds"], odds, 1e-9); near($c["segment_m"], 1024, 0); near($c["segments"], 22, 0); near($c["length_km"], 12, 1e-9); near($c["spacing_m"], 0.25, 1e-9)
  near($c["from_m"], 0, 1e-6); near($c["to_m"], 12000, 1e-6); near($c["misfit"] < 1.25, 1, 0)} END {near(rows, 2, 0)}' \
  A="$(v zone A)" Ae="$(v zone A_error)" phi="$(v zone phi_c)" B="$(v zone B_printed_mm)" Be="$(v zone B_printed_mm_error)" d="$(v zone deviation_mm)" odds="$(v zone odds_5)"
# Gaps are bridged as far as is asked: 1 m without a word, that is four samples here.
awk -F, -v OFS=, 'NR > 2000 && NR <= 2004 || NR > 4000 && NR <= 4005 {$2 = "nan"} 1' zone.csv >holes.csv
for bridge in ":5 4" "0:9 0" "3:9 0" "4:5 4" "5:0 9"; do
  # shellcheck disable=SC2046 # an option
  answers bridged classify holes.csv $([ -z "${bridge%:*}" ] || echo "--bridge ${bridge%:*}")
  [ "$(v bridged missing | cut -d. -f1) $(v bridged bridged | cut -d. -f1)" = "${bridge#*:}" ] || fail "bridge ${bridge%:*}: $(v bridged missing) missing, $(v bridged bridged) bridged"
done
# A section without a whole segment, of the power of two below a third of it, says so, and the others have theirs.
awk -F, -v OFS=, 'NR > 8002 && NR <= 12002 && NR % 200 < 20 || NR > 16002 && NR <= 20002 && NR % 1200 < 20 {$2 = "nan"} 1' zone.csv >torn.csv
"$railbook" psd classify torn.csv --section 1km --no-figures --out torn >said || fail "$(cat said)"
awk -F, 'NR == 1 {for (i = 1; i <= NF; ++i) c[$i] = i} $c["kind"] == "section" {++n; refused = refused ($c["status"] == "refused" ? n " " : ""); if ($c["status"] == "refused" && ($c["reason"] != "gaps leave no segment whole" || $c["missing"] != 397)) exit 1}
  END {exit !(n == 12 && refused == "3 ")}' torn/classify-table.csv || fail "a section of gaps: $(cut -d, -f1-12 torn/classify-table.csv)"
# The longest segments of which the record has four: 4096 samples of 10240, half of each in the next one, but not of one sample less.
"$railbook" psd synthesize long.csv --length 4km --spacing 25cm --roughness 5e-7m^2*cycle/m >/dev/null || fail "synthesize"
for case in 10240:1024:4:0 10239:512:8:1023 12288:1024:5:0; do
  head -$((${case%%:*} + 1)) long.csv >four.csv
  answers four classify four.csv
  awk -v m="$(v four segment_m)" -v n="$(v four segments)" -v case="$case" 'BEGIN {split(case, c, ":"); exit !(m == c[2] && n == c[3])}' || fail "segments of $case: $(grep segment four.json)"
  grep -q "\"segments\": \"(\{0,1\}${case##*:} samples in none" four.json || fail "samples in none of $case: $(grep '"segments"' four.json)"
done
# Acoustic roughness: a wave of 3 um and 80 mm on a rail is 10 lg(4.5) dB in its band, and little else is; two lines are averaged by their squares. A grain goes, and stays
# with --keep-spikes; a pit of 4 mm is bridged but for what the wheel reaches into it.
awk 'BEGIN {print "distance_m,left_um,right_um"; for (i = 0; i < 20000; ++i) {w = 2 * 3.14159265358979 * i / 80; z = 3 * sin(w)
  printf "%.3f,%.5f,%.5f\n", i / 1000, z, 2 * z + (i == 5000 ? 200 : 0) - (i > 8000 && i < 8004 ? 300 : 0)}}' >rail.csv
draws rough roughness rail.csv --column left,right
holds "levels" rough/roughness.csv '$2 == 80 {n[$1] = $3} $2 != 80 && $1 == "left" && $3 > -20 {print $0; wrong++} $2 == 80 {near($5, 2.9, 0); near($4 > 0 && $4 < 2, 1, 0)}
  END {near(n["left"], 10 * log(4.5) / log(10), 0.02); near(n["right"], 10 * log(18) / log(10), 0.03); near(n["average"], 10 * log(11.25) / log(10), 0.03); near(rows, 3 * 26, 0)}'
near "spikes of the left line" "$(v rough left_spikes)" 0 0
near "of the right one, whose pit has a sharp rim as well" "$(v rough right_spikes)" 4 2
grep -q '"left_above_limit_mm": "80"' rough.json || fail "above the limit: $(grep above rough.json)"
means rough 'says("left_bands", "1000 mm .a quarter of a segment. to 3.15 mm .three spacings of 1 mm."); is("left_bands", 26); warnings("right_outliers"); is("left_level_80_mm_dB", 10 * log(4.5) / log(10), 0.01)
  for (key in v) named[key]'
grow() { answers grown roughness rail.csv --column right "$@"; v grown level_5_mm_dB; }
near "a grain and a pit make more" "$(echo "$(grow --keep-spikes --no-wheel) $(grow)" | awk '{print ($1 > $2 + 10)}')" 1 0
