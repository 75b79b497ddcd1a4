#!/bin/bash
# hostile.sh RAILBOOK EXAMPLES: hostile and clumsy inputs. Each must be refused with status 2 and a reason, or answered; where the
# line says "warn", an answer must carry a warning or be refused. No signal, no hang, no library's own words.
railbook=$1 examples=$2
folder=$(mktemp -d) || exit 1
trap 'rm -rf "$folder"' EXIT
cd "$folder" || exit 1
ulimit -v 4000000 2>/dev/null
ulimit -c 0 -t 30
runs=0 failed=0
bad() { echo "BAD: $*"; echo "${said:0:600}"; failed=1; }
try() { # try EXPECTED arguments...: EXPECTED is refuse, warn or any
  wish=$1
  shift
  runs=$((runs + 1))
  "$railbook" "$@" >said 2>&1 </dev/null
  status=$?
  { said=$(<said); } 2>/dev/null # without zeros, which bash would tell of
  local LC_ALL=C # lengths in bytes
  case $said in
    *std::* | *basic_string* | *bad_alloc* | *terminate* | *CLI::* | *json.exception* | *'what()'* | *stod* | *fmt::* | *Aborted*)
      bad "a library speaks: $*" ;;
    *$'\033'*) bad "steers the terminal: $*" ;;
    "") bad "silent: $*" ;;
  esac
  [ ${#said} -lt 20000 ] || [ $status = 0 ] || bad "a message of ${#said} bytes: $*"
  case $wish-$status-$said in
    refuse-2-* | warn-2-* | any-[02]-* | warn-0-*WARNING*) ;;
    *) bad "status $status, not $wish: $*" ;;
  esac
}

"$railbook" psd synthesize good.csv --length 4km --roughness 5e-7m^2*cycle/m --corner 0.13cycle/m >/dev/null || exit 1
rows() { tail -n +2 good.csv; }
file() { cat >"$1.csv"; echo "$2:$1.csv" >>bodies; } # in a process of its own
: | file empty refuse
printf '\n\n\n' | file blank refuse
printf '# only a comment\n' | file comment refuse
printf 'distance_m,profile_mm\n' | file header refuse
printf 'distance_m,profile_mm\n0,1\n' | file one refuse
printf 'distance_m,profile_mm' | file headeronly refuse
head -c 3000 /dev/urandom | file noise refuse
printf '\0\0\0\0' | file zeros refuse
printf '\x1f\x8b\x08\x00garbage' | file gzip refuse
gzip -c good.csv | head -c 2000 | file gzipcut refuse
printf 'PK\x03\x04zipzip\n1,2\n' | file zip refuse
{ printf 'distance_m,profile_mm\n'; rows | sed '50s/.*/12,abc/'; } | file word refuse
{ printf 'distance_m,profile_mm\n'; rows | sed '50s/$/,7/'; } | file cells refuse
{ printf 'distance_m,profile_mm\n'; rows | sed '50s/,.*//'; } | file short refuse
{ printf 'distance_m,profile_mm\n'; rows | sed '50s/,.*/,"1/'; } | file quote refuse
{ printf 'distance_m,profile_mm\n'; rows | sed '50s/,.*/,inf/'; } | file inf refuse
{ printf 'distance_m,profile_mm\n'; rows | sed '50s/,.*/,1e999/'; } | file large refuse
{ printf 'distance_m,profile_mm\n'; rows | sed '50s/,.*/,0x12/'; } | file hex refuse
{ printf 'distance_m,profile_mm\n'; rows | sed '50s/,.*/,1.2.3/'; } | file dots refuse
{ printf 'distance_m,profile_mm\n'; rows | sed '50s/,.*/,1 2/'; } | file blankin refuse
{ printf 'distance_m,profile_mm\n'; rows | sed '50s/^[^,]*/nan/'; } | file nowhere warn
{ printf 'distance_m,profile_mm\n'; rows | sed '50s/^[^,]*/1e300/'; } | file far refuse
{ printf 'distance_m,profile_mm\n'; rows | sed '50s/^[^,]*/-5/'; } | file back refuse
{ printf 'distance_m,profile_mm\n'; rows | shuf --random-source=good.csv; } | file shuffled refuse
{ printf 'distance_m,profile_mm\n'; rows; rows; } | file twice refuse
{ printf 'distance_m,profile_mm\n'; rows | awk -F, '{print $1 ",7"}'; } | file constant refuse
{ printf 'distance_m,profile_mm\n'; rows | awk -F, '{print $1 ","}'; } | file none refuse
{ printf 'distance_m,profile_mm\n'; rows | awk -F, '{print "3," $2}'; } | file still refuse
{ printf 'distance_m,profile_kg\n'; rows; } | file mass refuse
{ printf 'distance_s,profile_mm\n'; rows; } | file seconds refuse
{ printf 'distance_m,profile\n'; rows; } | file unitless refuse
{ printf 'distance,profile_mm\n'; rows; } | file unitless2 refuse
{ printf 'distance_m,profile_mm,profile_mm\n'; rows | sed 's/$/,1/'; } | file same refuse
{ printf 'a;b,c\n'; rows; } | file mixed refuse
{ printf 'distance_m;profile_mm\n'; rows | awk -F, '{print $1 ";" (NR == 9 ? "1,5" : $2)}'; } | file commas refuse
{ printf 'distance_m,profile_mm\n'; rows | awk -F, 'NR % 40 == 3 {$2 = -9999} {print $1 "," $2}'; } | file code warn
{ printf 'distance_m,profile_mm\n'; rows | awk -F, 'NR == 700 {$2 += 900} {print $1 "," $2}'; } | file outlier warn
{ printf 'distance_m,profile_mm\n'; rows | awk -F, 'NR > 7000 {$2 += 900} {print $1 "," $2}'; } | file step warn
{ printf 'distance_m,profile_mm\n'; rows | awk -F, 'NR > 5000 && NR < 7000 {$2 = 3} {print $1 "," $2}'; } | file stuck warn
{ printf 'distance_m,profile_mm\n'; rows | awk -F, '{print $1 "," $2 / 1000}'; } | file metres warn
{ printf 'distance_m,profile_m\n'; rows; } | file millimetres warn
{ printf 'distance_m,profile_mm\n'; rows | awk -F, 'NR > 6000 {$1 += ($1 - 1800) * 0.01} {print $1 "," $2}'; } | file slip warn
{ printf 'distance_m,profile_mm\n'; rows | awk -F, 'NR > 6000 {$1 += ($1 - 1800) * 0.3} {print $1 "," $2}'; } | file wheel refuse
printf 'distance_m,%s\n0,1\n' "$(head -c 70000 /dev/zero | tr '\0' x)" | file longname refuse
printf 'distance_m,\033[31mprofile_mm\n0,1\n' | file escape refuse
yes 'a,b' | head -100000 | file words refuse
for body in $(cat bodies); do
  for tool in "psd classify" "quality index --speed 100km/h" "quality measures"; do try "${body%%:*}" $tool "${body#*:}"; done
done
head -c 70000000 /dev/zero | tr '\0' 7 >longline.csv # for one of those who read the same way
try refuse psd classify longline.csv

# Options.
for option in "--column" "--column=" "--column 0" "--column 99" "--column -1" "--column #" "--unit" "--unit=" "--unit kg" "--unit m/s" "--unit 1" "--distance nowhere" \
  "--distance +" "--distance a+b" "--distance-unit kg" "--spacing" "--spacing 0m" "--spacing -1m" "--spacing 1kg" "--spacing 1" "--spacing 1e-9m" "--spacing 1e9m" "--spacing nan" \
  "--bridge -1" "--bridge 1e9" "--bridge 2.5" "--skip -1" "--skip 1e9" "--skip 99999999999999999999" "--skip x" "--section 0m" "--section 1mm" "--section -1km" "--section 1kg" \
  "--manifest" "--manifest none.txt" "--manifest ." \
  "--out" "--out=" "--out good.csv" "--figure" "--figure=" "--figure ." "--figure /dev/null" "--figure x/y/z.png" "--figure a.png --out b" "--config" "--config none.toml" "--config ." \
  "--no-such" "-x" "--json --figure -"; do
  try refuse psd classify good.csv $option
done
for tool in "psd classify good.csv --low 0.1/m" "psd classify good.csv --low 5cycle/m --high 1cycle/m" "psd classify good.csv --reference german" "psd classify good.csv --window ''" \
  "quality measures good.csv --bands D9" "quality measures good.csv --passes 3" "quality measures good.csv --twist-base 1kg" "quality measures good.csv --gauge none" \
  "quality measures good.csv --bands" "quality index good.csv" "quality index good.csv --speed fast" "psd synthesize" "psd synthesize /dev/null" "psd synthesize good.csv/x" \
  "psd classify good.csv good.csv" "psd" "quality index" "" "help" "--nothing" "--completion tcsh" "psd synthesize x.csv --length 1e30km" "psd synthesize x.csv --seed -1"; do
  try refuse $tool
done

# Files of options.
toml() { printf "$1" >t.toml; try "${2:-refuse}" quality limit t.toml; }
toml 'speed'
toml 'speed ='
toml 'speed = "100km/h'
toml "speed = '100km/h"
toml 'speed = 100km/h"'
toml 'speed = 100'
toml 'speed = ["100km/h", "90km/h"]' any
toml 'speed = {a = 1}'
toml '[speed'
toml '[[speed]]'
toml 'speed = "100km/h"\nspeed = "90km/h"'
toml 'speed = "100km/h"\nsped = 1'
toml 'speed = "100km/h" extra'
toml 'speed = "\\q"'
toml 'speed = "\\u00"'
toml 'speed = """100km/h"""'
toml '= "100km/h"'
toml '\0\0\0'
toml 'speed = "100km/h"\nconfig = "t.toml"' any
toml '"spe\033[31med" = "100km/h"'
printf 'good.csv\0bad' >list.txt && try refuse psd classify --manifest list.txt
printf '\n# none\n' >list.txt && try refuse psd classify --manifest list.txt
printf 'good.csv\ngood.csv\n' >list.txt && try refuse psd classify --manifest list.txt
head -c 300 /dev/urandom >list.txt && try refuse psd classify --manifest list.txt
echo "$runs inputs"
[ $runs -ge 200 ] || { echo "too few"; exit 1; }
exit $failed
