#!/usr/bin/env bash
# Runs a command on SwiftShader, a Vulkan driver for the processor that has nothing in common with Mesa's. Debian's
# package chromium-common contains it. It is fetched once, and kept in $VPROBE_CACHE, else in ~/.cache/vprobe.
# usage: swiftshader.sh --fetch | swiftshader.sh COMMAND...
# Ends with 77 where the driver is not there.
set -euo pipefail
folder=${VPROBE_CACHE:-$HOME/.cache/vprobe}/swiftshader
driver=$folder/vk_swiftshader_icd.json

# Where Debian has put it, now or in older versions.
fetch_from()
{
	local scratch
	scratch=$(mktemp -d)
	(cd "$scratch" && apt-get -qq download "$1") 2>/dev/null &&
		dpkg-deb --fsys-tarfile "$scratch"/*.deb |
		tar -x -C "$folder" --strip-components=4 ./usr/lib/chromium/libvk_swiftshader.so ./usr/lib/chromium/vk_swiftshader_icd.json 2>/dev/null
	rm -rf "$scratch"
	[[ -s $folder/libvk_swiftshader.so && -s $driver ]]
}

if [[ ${1-} == --fetch ]]; then
	[[ -s $driver ]] && exit
	mkdir -p "$folder"
	for package in chromium-common chromium; do
		if fetch_from "$package"; then exit; fi
	done
	rm -rf "$folder"
	echo "no SwiftShader: apt-get download chromium-common does not give it" >&2
	exit 77
fi
[[ -s $driver ]] || exit 77
export VK_DRIVER_FILES=$driver VK_ICD_FILENAMES=$driver
exec "$@"
