#!/bin/sh
# corners_at_a_tenth.sh PROGRAM OUT BOOK: what "Try next" of chapter 04 promises. With both corners at a tenth the directions meet:
# the error of the run at 9 mph is a tenth. And the error of a coarse converter grows: of profile at 120 mph, typical sensors.
"$1" reproduce --only fig-directions,fig-parameters --no-figures --no-timings --out "$2" || exit 1
rms() { awk -F, '$2 == 9 { sum += $5 * $5; n++ } END { if (n < 100) exit 1; print sqrt(sum / n) }' "$1/fig-directions.csv"; }
coarse() { awk -F, '$1 == 120 && $2 == "typical" { print $5 }' "$1/fig-parameters.csv"; }
new=$2/results/04-filters
echo "$(rms "$3") $(rms "$new") $(coarse "$3") $(coarse "$new")" |
  awk '{ print "9 mph: " $1 " mm to " $2 "; 120 mph, typical: " $3 " mm to " $4
         exit !(NF == 4 && $2 > 0.05 * $1 && $2 < 0.15 * $1 && $4 > 10 * $3) }'
