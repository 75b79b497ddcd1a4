#!/bin/sh
# GSL and FFTW for the browser, from Debian's sources: libraries.sh CACHE leaves CACHE/libgsl.a,
# CACHE/libfftw3.a and CACHE/include. Only the folders that lib/ needs are compiled.
set -eu
cache=$1
[ -e "$cache/libgsl.a" ] && [ -e "$cache/libfftw3.a" ] && exit 0
mkdir -p "$cache/lists/partial" "$cache/archives/partial" "$cache/include"
cache=$(cd "$cache" && pwd)
unset EM_CACHE # Debian's is frozen, and complete
export NODE_PATH="${NODE_PATH:-/usr/share/nodejs}"

# deb-src lines of our own, so that the machine's list of sources stays as it is.
. /etc/os-release
echo "deb-src [signed-by=/usr/share/keyrings/debian-archive-keyring.gpg]" \
     "http://deb.debian.org/debian $VERSION_CODENAME main" > "$cache/sources.list"
get="-qq -o Dir::Etc::SourceList=$cache/sources.list -o Dir::Etc::SourceParts=-
     -o Dir::State::Lists=$cache/lists -o Dir::Cache=$cache"
cd "$cache"
apt-get $get update
for package in gsl fftw3; do
  [ -d $package ] || {
    apt-get $get source --download-only $package
    rm -rf unpacked
    dpkg-source --no-check -x "$(echo ${package}_*.dsc)" unpacked > /dev/null
    mv unpacked $package
  }
done

# The configuration script does not know wasm32; i686 has the same sizes.
configure="nice emconfigure ./configure --host=i686-linux-gnu --disable-shared --quiet"
jobs=$(nproc)
cd "$cache/gsl"
[ -e config.h ] || $configure CFLAGS=-O3
make -s -C gsl > /dev/null
for folder in err sys utils vector matrix block permutation complex sort poly cblas blas linalg \
              eigen roots integration specfunc cdf interpolation ode-initval2; do
  nice emmake make -s -j "$jobs" -C $folder > /dev/null
done
emar rcs "$cache/libgsl.a" $(find . -name '*.o' -not -path '*/.libs/*')
rm -rf "$cache/include/gsl"
cp -rL gsl "$cache/include/gsl"

# Of FFTW's ready-made pieces those of up to 16 points are enough: larger transforms are composed of them,
# and the module is a quarter smaller. Cosine transforms are not used.
cd "$cache/fftw3"
[ -e config.h ] || $configure CFLAGS=-O3 --disable-fortran --disable-doc
sed -i -E '/SOLVTAB\(X\(codelet_((q1|t2|hf2|hb2|hc2cf2|hc2cb2|hc2c[fb]dft2?)_[0-9]+|[a-zA-Z0-9]+_(20|25|32|64|128))\)\)/d' \
  dft/scalar/codelets/codlist.c rdft/scalar/r2c[fb]/codlist.c
sed -i '/reodft_conf_standard)(/d' api/configure.c
for folder in support kernel simd-support dft rdft api; do
  nice emmake make -s -j "$jobs" -C $folder > /dev/null
done
emar rcs "$cache/libfftw3.a" $(find kernel simd-support dft rdft api -name '*.o' -not -path '*/.libs/*')
cp api/fftw3.h "$cache/include/"
