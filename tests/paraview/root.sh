#!/usr/bin/env bash
# Where ParaView's Python and CMake files are, beside Debian's python3-vtk9: python3-paraview and it exclude each other,
# so that package is unpacked in the cache, with links to the rest of ParaView.
# usage: tests/paraview/root.sh          prints the folder that stands for /usr, or says in one line why there is none
#        tests/paraview/root.sh --fetch  installs ParaView (Debian 12) and fills the cache before
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."

root=${VPROBE_CACHE:-$HOME/.cache/vprobe}/paraview/root
installed=/usr/lib/python3/dist-packages/paraview/simple.py

# fill_root: python3-paraview and CMake's files as they are, since they look for others by their own place; of all else
# links.
fill_root()
{
	local new=$root.new
	rm -rf "$new" "$root"
	mkdir -p "$new"
	(cd "$new" && apt-get -qq download python3-paraview && dpkg -x python3-paraview_*.deb . && rm ./*.deb)
	dpkg -L paraview paraview-dev | grep -E '^/usr/(bin|include|lib)/' | grep -v /cmake/ |
		while IFS= read -r file; do [[ -d $file ]] || printf '%s\n' "$file"; done |
		xargs -d '\n' cp -s --parents -t "$new"
	cp -a --parents /usr/lib/x86_64-linux-gnu/cmake/paraview-5.11 "$new"
	mv "$new" "$root"
}

if [[ ${1-} == --fetch ]]; then
	source apps/setup.sh
	[[ $system == debian12 ]] || { say "ParaView is fetched on Debian 12 only"; exit 1; }
	install_packages "${paraview_packages[@]}"
	if [[ ! -d $root && ! -e $installed ]]; then
		step build/log/paraview-root "Unpacking python3-paraview" fill_root
	fi
fi

for program in pvbatch pvserver mpiexec; do
	if ! command -v "$program" >/dev/null; then
		echo "no $program; tests/paraview/root.sh --fetch installs it" >&2
		exit 1
	fi
done
if [[ -e $installed ]]; then
	echo /usr
elif [[ -d $root ]]; then
	echo "$root/usr"
else
	echo "no python3-paraview; tests/paraview/root.sh --fetch unpacks it" >&2
	exit 1
fi
