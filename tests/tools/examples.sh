#!/bin/sh
# examples.sh RAILBOOK EXAMPLES: forty things that people do with a record of their own, each with a word that its answer must hold.
railbook=$1 examples=$2
folder=$(mktemp -d) || exit 1
trap 'rm -rf "$folder"' EXIT
cd "$folder" || exit 1
railbook() { "$railbook" "$@"; }
railbook psd synthesize track.csv --length 12km --spacing 25cm --roughness 5e-7m^2*cycle/m --corner 0.13cycle/m --dip 11mm >/dev/null || exit 1
railbook psd synthesize later.csv --length 12km --spacing 25cm --roughness 6e-7m^2*cycle/m --corner 0.13cycle/m --dip 14mm >/dev/null || exit 1
railbook psd synthesize long-rails.csv --length 20km --spacing 25cm --roughness 5e-7m^2*cycle/m --corner 0.13cycle/m --dip 14mm --rail 25m >/dev/null || exit 1
railbook psd synthesize gaps.csv --length 20km --spacing 25cm --roughness 5e-7m^2*cycle/m --corner 0.13cycle/m --gaps 0.01 >/dev/null || exit 1
sed 's/profile/left/' track.csv | paste -d, - track.csv later.csv | cut -d, -f1,2,4,6 | sed '1s/.*/distance_m,left_mm,right_mm,cant_mm/' >rails.csv
gzip -k track.csv
tr ',.' ';,' <track.csv >comma.csv
printf 'track.csv\nlater.csv\n' >list.txt
printf 'column = "profile"\nspeed = "100km/h"\n' >case.toml
n=0 failed=0
while IFS='|' read -r pattern command <&3; do
  [ -n "$command" ] || continue
  n=$((n + 1))
  eval "$command" >said 2>&1
  status=$?
  { [ $status = 0 ] && grep -q -e "$pattern" said; } || { echo "status $status, no \"$pattern\": $command"; head -40 said; failed=1; }
done 3<<'END'
  class  *5 |railbook psd classify track.csv
rail length  *11.89 m|railbook psd classify track.csv --rail 39ft
shows rails of 2[45]|railbook psd classify long-rails.csv
"rail|railbook psd classify long-rails.csv --json
 800 missing|railbook psd classify gaps.csv
length of a segment  *128 m|railbook psd classify gaps.csv --segment 512
of german-low|railbook psd classify track.csv --reference german-low
the record is worse|railbook psd classify track.csv --reference china-hsr
the record is better|railbook psd classify track.csv --reference fra-1
hamid-yang-5|railbook psd classify track.csv --reference fra-5,hamid-yang-5,german-high
  class  *5 |railbook psd classify track.csv --slopes two --noise none
  class  *5 |railbook psd classify track.csv --window dpss
  class  *5 |railbook psd classify track.csv --low 0.02cycle/m --high 1cycle/m
roughness A  *4.8e-07 +- 2e-08|railbook psd classify track.csv.gz
roughness A  *4.8e-07 +- 2e-08|railbook psd classify comma.csv
roughness A  *4.8e-07 +- 2e-08|railbook psd classify - <track.csv
roughness A  *4.8e-07 +- 2e-08|gzip -dc track.csv.gz | railbook psd classify - --column 2
roughness A  *4.8e-07 +- 2e-08|cut -d, -f2 track.csv | railbook psd classify - --spacing 25cm
roughness A  *5.[5-9]|railbook psd classify rails.csv --column 4
rows of the table  *2|railbook psd classify rails.csv --column left,right --out columns --no-figures
rows of the table  *2|railbook psd classify --manifest list.txt --out listed --no-figures
rows of the table  *26|railbook psd classify track.csv later.csv --section 1km --out sections --no-figures
PNG|railbook psd classify track.csv --figure - | head -c 8
D1, median deviation|railbook quality measures track.csv
D0, median deviation|railbook quality measures track.csv --bands D0,D1
D1|railbook quality measures track.csv --passes 1 --section 1km
twist, median deviation|railbook quality measures rails.csv --column left,right --crosslevel cant --twist-base 10m
exceptions to FRA class 3|railbook quality measures track.csv --fra-class 3
exceptions to limits.csv|railbook quality measures track.csv --limits $examples/quality/limits.csv --speed 100km/h
chord_31ft_largest_mm|railbook quality measures track.csv --chords 31ft 124ft --out chords --no-figures && head -1 chords/measures.csv
length of a section  *160.9 m|railbook quality measures track.csv --section 528ft
median growth|railbook quality compare track.csv later.csv --section 500m
from_m,to_m,before_mm,after_mm|railbook quality compare track.csv track.csv --out same --no-figures && cat same/compare.csv
offset|railbook quality compare track.csv track.csv --window 100m --reach 5m
limit|railbook quality limit --speed 100km/h
limit|railbook quality limit --speed 60mph --car $examples/quality/freight.toml
limit|railbook quality index track.csv --config case.toml --unit mm
segment|railbook quality index track.csv --speed 100km/h --section 500m
"speed": "60mph"|railbook quality index track.csv --speed 60mph --json
distance_m,profile_mm|railbook psd synthesize - --length 100m --roughness 1e-7m^2*cycle/m --seed 7
rows|railbook filters simulate --out sensors.csv --length 2000ft --seed 3 --config $examples/filters/car.toml
vertical_left: no value at all|awk -F, -v OFS=, 'NR > 1 {$3 = ""} 1' sensors.csv >dead.csv && railbook filters process dead.csv
gage, mean where good  *143[0-9]|railbook filters process sensors.csv --config $examples/filters/car.toml --chord 30ft --sample 1ft
END
echo "$n examples"
[ $n -ge 40 ] || failed=1
exit $failed
