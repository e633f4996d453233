#!/usr/bin/env bash
# Makes the Debian packages vprobe, vprobe-view, libvprobe0, libvprobe-dev and python3-vprobe of a release build, and says
# where they are.
# usage: apps/package.sh [FOLDER]    FOLDER: where they go; build/packages without it
set -euo pipefail
target=$(realpath -m "${1:-$(dirname "$0")/../build/packages}")
cd "$(dirname "$0")/.."
source apps/setup.sh
install_packages "${build_packages[@]}" "${python_packages[@]}" dpkg-dev file
# A build folder that has the tests keeps them.
if [[ ! -e build/release/build.ninja ]]; then
	configure release -DVPROBE_TESTS=OFF -DVPROBE_BENCH=OFF
fi
step build/log/packages-build "Building" cmake --build build/release
mkdir -p "$target"
rm -f "$target"/*.deb
step build/log/packages "Packing" cpack --config build/release/CPackConfig.cmake -B "$target"
rm -rf "$target/_CPack_Packages"
ls -1 "$target"/*.deb
