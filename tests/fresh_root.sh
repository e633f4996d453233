# shellcheck shell=bash
# Makes a root file system of Debian, new by debootstrap, in $root, and inside() to run a command in it. It goes when the
# script that sources this ends, unless $kept_root names it: then it stays in the cache and is used again. Needs $suite,
# and the script's arguments. Needs root and debootstrap. Downloads and compiled objects are kept in $VPROBE_CACHE, else
# in ~/.cache/vprobe.

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
if [[ -n ${kept_root-} ]]; then
	root=$cache/$kept_root
	mkdir -p "$root"
	[[ -e $root/made ]] || rm -rf --one-file-system "${root:?}"/* # a root that was not finished
else
	root=$(mktemp -d -p "$cache" root.XXXX)
fi
chmod 755 "$root" # tests that drop root's rights still reach their files
mount --bind "$root" "$root"
if [[ -n ${kept_root-} ]]; then
	trap 'umount -lR "$root"' EXIT
else
	trap 'umount -lR "$root"; rm -rf --one-file-system "$root"' EXIT
fi

if [[ ! -e $root/made ]]; then
	debootstrap --variant=minbase --cache-dir="$cache/packages" --keyring="$keys" "$suite" "$root" "$mirror"
	touch "$root/made"
fi
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

inside() { chroot "$root" env -i HOME=/root LANG=C.UTF-8 PATH=/usr/sbin:/usr/bin:/sbin:/bin "$@"; }
