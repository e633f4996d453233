#!/usr/bin/env bash
# TBB for the thread sanitizer, built from Debian's source in the cache. With it the sanitizer sees that loops wait for
# their bodies, so the tests may use all cores.
# usage: tests/tsan_tbb.sh          prints its folder, or says in one line why there is none
#        tests/tsan_tbb.sh --fetch  fetches and builds it before, if it is not there
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

root=${VPROBE_CACHE:-$HOME/.cache/vprobe}/tsan-tbb
clang=$(command -v clang++-14 || command -v clang++ || true)

# fetch_source FOLDER: by lists of packages of its own, since most systems have no lists of sources.
fetch_source()
{
	local folder=$1
	mkdir -p "$folder"/{lists/partial,cache/archives/partial}
	echo "deb-src [signed-by=/usr/share/keyrings/debian-archive-keyring.gpg] http://deb.debian.org/debian $(. /etc/os-release && echo "$VERSION_CODENAME") main" >"$folder/sources.list"
	local apt=(apt-get -qq -o Dir::Etc::SourceParts=/dev/null -o "Dir::Etc::SourceList=$folder/sources.list"
		-o "Dir::State::Lists=$folder/lists" -o "Dir::Cache=$folder/cache")
	"${apt[@]}" update && (cd "$folder" && "${apt[@]}" source --download-only onetbb && tar xf onetbb_*.orig.tar.*)
}

build_tbb()
{
	local new=$root.new
	rm -rf "$new" "$root"
	fetch_source "$new/source"
	cmake -S "$new"/source/oneTBB-* -B "$new/made" -G Ninja -DCMAKE_BUILD_TYPE=RelWithDebInfo -DCMAKE_CXX_COMPILER="$clang" \
		-DCMAKE_CXX_FLAGS='-fsanitize=thread -O1 -g1' -DCMAKE_SHARED_LINKER_FLAGS=-fsanitize=thread -DTBB_TEST=OFF \
		-DTBB_STRICT=OFF -DTBBMALLOC_BUILD=OFF -DTBB_DISABLE_HWLOC_AUTOMATIC_SEARCH=ON -DCMAKE_INSTALL_PREFIX="$new/installed"
	cmake --build "$new/made"
	cmake --install "$new/made"
	mv "$new/installed" "$root"
	rm -rf "$new"
}

if [[ ${1-} == --fetch && ! -e $root && -n $clang ]] && command -v apt-get >/dev/null; then
	build_tbb >&2
fi
if [[ -z $clang ]]; then
	echo "no clang"
	exit 1
fi
if [[ ! -e $root/lib/cmake/TBB ]]; then
	echo "no TBB for it; tests/tsan_tbb.sh --fetch builds one from Debian's source"
	exit 1
fi
echo "$root"
