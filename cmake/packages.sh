#!/bin/sh
# packages.sh check|install: what of packages.txt this machine lacks; `install` gets it with apt (Debian, Ubuntu).
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

parts() { echo "$1" | tr '&' ' '; }
choices() { echo "$1" | tr '|' ' '; }
all() { # all TEST NAME&NAME: whether the test holds of each
  for part in $(parts "$2"); do "$1" "$part" || return 1; done
}
installed() { dpkg-query -W -f '${Status}' "$1" 2>/dev/null | grep -q 'ok installed'; }
known() { apt-cache show --no-all-versions "$1" >/dev/null 2>&1; }

lacking=
for name in $names; do
  found=
  for choice in $(choices "$name"); do ! all installed "$choice" || found=yes; done
  [ -n "$found" ] || lacking="$lacking $name"
done
if [ -z "$lacking" ]; then
  [ "$1" = install ] || echo "All packages of packages.txt are installed."
  exit 0
fi
echo "Missing packages:$lacking"
[ "$1" = install ] || exit 1

root=
by_hand() {
  echo "$1 This line, run by an administrator, installs them:"
  echo "  apt-get update && apt-get install --no-install-recommends$(echo "$lacking" | sed -e 's/|[^ ]*//g')"
  exit 1
}
if [ "$(id -u)" -ne 0 ]; then
  command -v sudo >/dev/null 2>&1 || by_hand "You are not root, and there is no sudo."
  sudo true || by_hand "sudo does not let you install packages."
  root="sudo env DEBIAN_FRONTEND=noninteractive" # sudo drops the environment
fi
export DEBIAN_FRONTEND=noninteractive
$root apt-get update -qq

# Of each line with alternatives the first that this release has; none of them is no hindrance.
wanted=
for name in $lacking; do
  choice=$name
  case $name in
    *'|'*)
      choice=
      for one in $(choices "$name"); do [ -n "$choice" ] || ! all known "$one" || choice=$one; done
      [ -n "$choice" ] || echo "No package here gives $name; what needs it is left out." ;;
  esac
  wanted="$wanted $(parts "$choice")"
done
[ -n "$(echo "$wanted" | tr -d ' ')" ] || exit 0

# shellcheck disable=SC2086  # lists of words, here and below
plan=$(apt-get install -s -qq --no-install-recommends $wanted | grep -c '^Inst ') || plan=0
# shellcheck disable=SC2086
size=$(apt-get install --print-uris -qq --no-install-recommends $wanted | awk '{ s += $3 } END { printf "%.1f", s / 1e6 }')
echo "Installing with apt-get: $plan packages with what they depend on, $size MB to fetch."
# shellcheck disable=SC2086
$root apt-get install -y -qq --no-install-recommends $wanted >/dev/null
