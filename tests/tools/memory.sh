#!/bin/sh
# memory.sh RAILBOOK: tools that read records do so in a memory that does not grow with them: 250 km, 820,000 samples.
railbook=$1
folder=$(mktemp -d) || exit 1
trap 'rm -rf "$folder"' EXIT
cd "$folder" || exit 1
(ulimit -v 60000; "$railbook" --version) >/dev/null 2>&1 || exit 77  # a sanitizer, or no such limit
"$railbook" psd synthesize first.csv --length 250km --roughness "5e-7m^2*cycle/m" >/dev/null || exit 1
for tool in "quality measures first.csv" "quality index first.csv --speed 60mph" "psd classify first.csv"; do
  # shellcheck disable=SC2086
  (ulimit -v 60000; exec "$railbook" $tool) >out 2>&1 || { echo "railbook $tool:"; cat out; exit 1; }
done

# Where the memory is not enough, the tool says so: status 3 and no word of a library.
(ulimit -v 150000; exec "$railbook" contact solve --body-1-radius-across 300mm --body-1-radius-along 460mm --load 100kN --cells-x 2047 --cells-y 2047) >out 2>&1
[ $? = 3 ] && grep -q "not enough memory" out || { echo "without memory:"; cat out; exit 1; }
