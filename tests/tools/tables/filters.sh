# Sourced by tables.sh.
# A run forth, back and forth: speeds have no sign, rows are in order of the road.
"$railbook" filters simulate --out drive.csv --length 4000ft --speeds 40mph 0mph -20mph 0mph 40mph --distances 1500ft 1ft 800ft 1ft 300ft --stand 60s >/dev/null || fail "simulate"
answers geometry process drive.csv
near "fastest" "$(v geometry fastest_mph)" 40 0.01
awk -v slow="$(v geometry slowest_mph)" 'BEGIN {exit !(slow > 0 && slow < 5)}' || fail "slowest: $(v geometry slowest_mph)"
near "gage" "$(v geometry gage_mean)" 1435 2
# A road counted from elsewhere is the same road.
awk -F, -v OFS=, 'NR == 1 {for (i = 1; i <= NF; ++i) if ($i ~ /^distance/) d = i} NR > 1 {$d += 0.1} 1' drive.csv >moved.csv
answers moved process moved.csv
for key in rows rejected runs gage_mean crosslevel_mean; do near "$key elsewhere" "$(v moved $key)" "$(v geometry $key)" 1e-6; done
holds "gage in the table" geometry/geometry.csv '$c["gage_is"] == "good" {sum += $c["gage_mm"]; squares += $c["gage_mm"] ^ 2; ++n}
  END {mean = sum / n; near(mean, m, 1e-3); near(sqrt(squares / n - mean ^ 2), d, 0.01); near(100 * n / rows, g, 0.1)}' \
  m="$(v geometry gage_mean)" d="$(v geometry gage_deviation)" g="$(v geometry gage_good_percent)"
