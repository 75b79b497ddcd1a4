#!/usr/bin/env bash
# The README's two commands on bare systems: tests/fresh/run.sh [--user] [bookworm|trixie ...]
# Makes a root of each release with debootstrap, with nothing in it but the base system, git and make; clones the committed
# state of this checkout into it; runs `make reproduce` and `make test`; reports. As root, or with sudo. With --user the two
# commands are run by an ordinary user who may use sudo. $ROOTS keeps the bare roots and the packages for the next time
# (1 GB a release); $MIRROR is the archive. Exit status: 0 when both commands succeeded in every root.
set -euo pipefail
here=$(cd "$(dirname "$0")/../.." && pwd)
ROOTS=${ROOTS:-/var/tmp/railbook-roots}
MIRROR=${MIRROR:-http://deb.debian.org/debian}
user=root
[[ ${1:-} != --user ]] || { user=builder && shift; }
releases=("${@:-bookworm}")
(($# > 0)) || releases=(bookworm trixie)
((EUID == 0)) || exec sudo ROOTS="$ROOTS" MIRROR="$MIRROR" "$0" $([[ $user == root ]] || echo --user) "${releases[@]}"
command -v debootstrap > /dev/null || { echo "debootstrap is not installed; on Debian: apt-get install debootstrap"; exit 2; }

work=
leave() {
  [[ -n $work ]] || return 0
  for place in var/cache/apt/archives dev proc; do umount -l "$work/$place" 2> /dev/null || true; done
  rm -rf --one-file-system "$work"
  work=
}
trap leave EXIT

bare_root() { # bare_root RELEASE: $ROOTS/RELEASE.tar, made once
  [[ -f $ROOTS/$1.tar ]] && return
  local fresh=$ROOTS/$1.new
  rm -rf "$fresh"
  debootstrap --variant=minbase --include=git,make,ca-certificates,sudo "$1" "$fresh" "$MIRROR"
  rm -f "$fresh"/var/cache/apt/archives/*.deb
  tar -C "$fresh" -cf "$ROOTS/$1.tar.new" .
  mv "$ROOTS/$1.tar.new" "$ROOTS/$1.tar"
  rm -rf "$fresh"
}

inside() { # inside COMMAND: as the user, in the clone, with a clean environment
  chroot "$work" env -i PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin LC_ALL=C.UTF-8 \
    su "$user" -s /bin/bash -c "cd ~/railbook && $1"
}

mkdir -p "$ROOTS"
failed=0
for release in "${releases[@]}"; do
  bare_root "$release" > "$ROOTS/$release-debootstrap.log" 2>&1 ||
    { tail -n 3 "$ROOTS/$release-debootstrap.log"; echo "$release: debootstrap failed"; exit 1; }
  work=$ROOTS/$release.work
  leave
  work=$ROOTS/$release.work
  mkdir -p "$work" "$ROOTS/$release-debs/partial"
  tar -C "$work" -xpf "$ROOTS/$release.tar"
  mount -t proc proc "$work/proc"
  mount --bind /dev "$work/dev"
  mount --bind "$ROOTS/$release-debs" "$work/var/cache/apt/archives"
  cp /etc/resolv.conf "$work/etc/resolv.conf"
  if [[ $user != root ]]; then
    chroot "$work" useradd -m "$user"
    echo "$user ALL=(ALL) NOPASSWD: ALL" > "$work/etc/sudoers.d/$user"
  fi
  home=$(chroot "$work" getent passwd "$user" | cut -d: -f6)
  git -c safe.directory='*' clone -q "$here" "$work$home/railbook"
  chroot "$work" chown -R "$user" "$home/railbook"
  for command in "make reproduce" "make test"; do
    log=$ROOTS/$release-${command#make }.log
    SECONDS=0
    good=good
    inside "$command" > "$log" 2>&1 || { good=FAILED && failed=1; }
    echo "$release, $user, $command: $good, $SECONDS s; $(grep -E 'tests passed|^book: ' "$log" | tail -n 1) ($log)"
  done
  leave
done
exit "$failed"
