#!/usr/bin/env bash
# Times the program beside the VTK of this system and the VTK 9.3 of Debian 13, in turns on the same machine. VTK 9.3
# and the same benchmark live in a root file system of Debian 13, which stays in the cache (tests/fresh_root.sh).
# usage: tests/bench/newer_vtk.sh [FILTER] [TURNS]    FILTER: as in bench_cut's --benchmark_filter; TURNS: 20
#        tests/bench/newer_vtk.sh --can-run           only says why it cannot, if it cannot
# Needs build/release/bin/bench_cut (cmake --preset release -DVPROBE_BENCH=ON).
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
project=$PWD

suite=trixie
kept_root=bench
source tests/fresh_root.sh

source apps/setup.sh
here=$project/build/release/bin/bench_cut
if [[ ! -x $here ]]; then
	echo "no $here; cmake --preset release -DVPROBE_BENCH=ON, then ninja -C build/release bench_cut"
	exit 1
fi

inside apt-get -qq update
inside env DEBIAN_FRONTEND=noninteractive apt-get -qq install -y --no-install-recommends \
	"${build_packages[@]}" libbenchmark-dev libgtest-dev libgmock-dev libmuparser-dev >/dev/null
mount --bind -o ro "$project" "$root/source"
mkdir -p "$root/build"
inside cmake -S /source -B /build -G Ninja -DCMAKE_BUILD_TYPE=Release -DVPROBE_TESTS=ON -DVPROBE_BENCH=ON \
	-DCMAKE_CXX_COMPILER_LAUNCHER=ccache >/dev/null
step build/log/newer-vtk "Building the benchmark with VTK 9.3" inside ninja -C /build bench_cut vprobe

python3 tests/bench/turns.py "${2:-20}" "${1:-.}" "VTK 9.1=$here" \
	"VTK 9.3=chroot $root env -i HOME=/root PATH=/usr/bin:/bin /build/bin/bench_cut"
