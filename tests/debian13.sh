#!/usr/bin/env bash
# Builds the program, draws with it and runs the tests of the release build in a root file system of Debian 13, made anew by
# debootstrap.
# Needs root and debootstrap. Downloads and compiled objects are kept in $VPROBE_CACHE, else in ~/.cache/vprobe.
# usage: tests/debian13.sh [--can-run]    --can-run: only says why it cannot, if it cannot
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

suite=trixie
mirror=http://deb.debian.org/debian
keys=/usr/share/keyrings/debian-archive-keyring.gpg
cache=${VPROBE_CACHE:-$HOME/.cache/vprobe}/$suite

why_not=
((EUID == 0)) || why_not="needs root, for debootstrap and chroot"
command -v debootstrap >/dev/null || why_not="no debootstrap; apt-get install debootstrap"
if [[ -n $why_not ]]; then
	echo "$why_not"
	exit 1
fi
[[ ${1-} == --can-run ]] && exit 0

# Mounts live in a mount namespace of their own and go with it, however this ends.
if [[ -z ${VPROBE_OWN_MOUNTS-} ]]; then
	VPROBE_OWN_MOUNTS=1 exec unshare --mount --propagation private bash "$0" "$@"
fi

mkdir -p "$cache"/{packages,archives/partial,ccache}
cache=$(cd "$cache" && pwd)
root=$(mktemp -d -p "$cache" root.XXXX)
chmod 755 "$root" # tests that drop root's rights still reach their files
mount --bind "$root" "$root"
trap 'umount -lR "$root"; rm -rf --one-file-system "$root"' EXIT

debootstrap --variant=minbase --cache-dir="$cache/packages" --keyring="$keys" "$suite" "$root" "$mirror"
cp /etc/resolv.conf "$root/etc/"
# Whatever the host needs to reach its mirror.
find /etc/apt/apt.conf.d -maxdepth 1 -name '*proxy*' -exec cp {} "$root/etc/apt/apt.conf.d/" \;
rm -f "$root/etc/apt/apt.conf.d/docker-clean"
echo 'Binary::apt-get::APT::Keep-Downloaded-Packages "true";' >"$root/etc/apt/apt.conf.d/90keep"
echo force-unsafe-io >"$root/etc/dpkg/dpkg.cfg.d/unsafe-io" # the root is thrown away
mkdir -p "$root"/{source,root/.cache/ccache}
mount --bind "$cache/archives" "$root/var/cache/apt/archives"
mount --bind "$cache/ccache" "$root/root/.cache/ccache"
mount --rbind /proc "$root/proc"
mount --rbind /sys "$root/sys"
mount --rbind /dev "$root/dev"

# The files under version control, as they are now.
git ls-files -z | tar --null -T - -cf - | tar -C "$root/source" -xf -

inside() { chroot "$root" env -i HOME=/root LANG=C.UTF-8 PATH=/usr/sbin:/usr/bin:/sbin:/bin "$@"; }
inside bash /source/apps/demo.sh
inside test -s /source/build/demo-shell.png
inside bash /source/tests/run.sh --release
