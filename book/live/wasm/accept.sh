#!/bin/sh
# accept.sh CACHE: compiles the live module by emscripten and puts it, packed, into book/live/module.js.
# GSL and FFTW are made once and kept in CACHE.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
cache=$1
command -v em++ > /dev/null || { echo "em++ is not installed; on Debian: sudo apt-get install emscripten"; exit 2; }
unset EM_CACHE # Debian's is frozen, and complete
export NODE_PATH="${NODE_PATH:-/usr/share/nodejs}"
"$here/libraries.sh" "$cache"
cache=$(cd "$cache" && pwd)
emcmake cmake -S "$here" -B "$cache/module" -G Ninja -DLIBRARIES="$cache" -DCMAKE_BUILD_TYPE= > /dev/null
cmake --build "$cache/module"
node "$here/pack.mjs" "$cache/module/live.js" "$cache/module/live.wasm" "$here/loader.js" "$here/../module.js"
