#!/usr/bin/env bash
# Makes the packages of a build, and holds their files against contents.txt beside this script. After a change that is
# meant: files.sh BUILD_FOLDER SCRATCH_FOLDER --update
# Checks that desktop files, the AppStream data and the manual pages are well formed, by the tools that are installed.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
build=$1 scratch=$2
source=$here/../../apps/package
command -v dpkg-deb >/dev/null || { echo "no dpkg-deb here, so no packages"; exit 77; }
rm -rf "$scratch"
mkdir -p "$scratch"
(cd "$scratch" && cpack --config "$build/CPackConfig.cmake" -B "$scratch/packages" >"$scratch/cpack.log") || {
	cat "$scratch/cpack.log"
	exit 1
}
packages=("$scratch"/packages/*.deb)
for package in "${packages[@]}"; do
	name=$(dpkg-deb -f "$package" Package)
	dpkg-deb -c "$package" | awk -v name="$name" '$6 !~ /\/$/ { print name ": " substr($6, 2) }'
done | sed "s#/usr/lib/$(dpkg-architecture -qDEB_HOST_MULTIARCH)/#/usr/lib/#; s#_core[.].*[.]so#_core.so#" | LC_ALL=C sort >"$scratch/contents.txt"
[[ ${3-} != --update ]] || cp "$scratch/contents.txt" "$here/contents.txt"
expected=$here/contents.txt
if ! compgen -G "$scratch/packages/python3-vprobe_*.deb" >/dev/null; then # built without Python
	grep -v '^python3-vprobe' "$here/contents.txt" >"$scratch/expected.txt"
	expected=$scratch/expected.txt
fi
diff "$expected" "$scratch/contents.txt"

for package in "${packages[@]}"; do
	dpkg-deb -f "$package" Depends | grep -q . || { echo "$package depends on nothing"; exit 1; }
done
dpkg-deb -f "$scratch"/packages/libvprobe0_*.deb Depends | grep -qE 'vtk|hdf5' && { echo "libvprobe0 needs VTK or HDF5"; exit 1; }

dpkg-deb -f "$scratch"/packages/vprobe_*.deb Depends | grep -qE 'glfw|libx11' && { echo "vprobe needs a window"; exit 1; }
dpkg-deb -f "$scratch"/packages/vprobe-view_*.deb Depends | grep -q glfw || { echo "vprobe-view needs no GLFW"; exit 1; }

if command -v desktop-file-validate >/dev/null; then
	desktop-file-validate "$source/vprobe.desktop"
fi
if command -v appstreamcli >/dev/null; then
	appstreamcli validate --no-net "$source/vprobe.metainfo.xml"
fi
if command -v lintian >/dev/null; then
	lintian --allow-root --fail-on error "${packages[@]}"
fi
if command -v man >/dev/null; then
	for page in "$build"/apps/package/made/man/*.gz; do
		wrong=$(MANWIDTH=80 LC_ALL=C.UTF-8 man --warnings=w -l "$page" 2>&1 >/dev/null)
		[[ -z $wrong ]] || { echo "$page: $wrong"; exit 1; }
	done
fi
echo "$(wc -l <"$scratch/contents.txt") files in ${#packages[@]} packages"
