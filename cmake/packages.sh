#!/bin/sh
# packages.sh check|install: what of packages.txt this machine lacks; `install` gets it with apt (Debian 12).
set -eu
cd "$(dirname "$0")/.."
names=$(sed -e 's/#.*//' -e 's/[[:space:]].*//' -e '/^$/d' packages.txt)

if ! command -v dpkg-query >/dev/null 2>&1 || ! command -v apt-get >/dev/null 2>&1; then
  [ "$1" = check ] || [ -n "${RAILBOOK_ASSUME_PACKAGES:-}" ] && exit 0
  echo "This is not a Debian system. Install what corresponds to these packages, then"
  echo "run again with RAILBOOK_ASSUME_PACKAGES=1:"
  sed -e '/^#/d' packages.txt
  exit 1
fi

missing=
for name in $names; do
  dpkg-query -W -f '${Status}' "$name" 2>/dev/null | grep -q 'ok installed' || missing="$missing $name"
done
if [ -z "$missing" ]; then
  [ "$1" = install ] || echo "All packages of packages.txt are installed."
  exit 0
fi
echo "Missing packages:$missing"
[ "$1" = install ] || exit 1

root=
if [ "$(id -u)" -ne 0 ]; then
  command -v sudo >/dev/null 2>&1 || { echo "Not root and no sudo: install them by hand."; exit 1; }
  root=sudo
fi
echo "Installing them with apt-get."
$root apt-get update -qq
# shellcheck disable=SC2086  # a list of words
DEBIAN_FRONTEND=noninteractive $root apt-get install -y -qq --no-install-recommends $missing >/dev/null
