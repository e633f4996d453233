#!/usr/bin/env bash
# Builds the plugin: installs the library of build/release into build/paraview-prefix, and configures the plugin against it.
# usage: apps/paraview/build.sh [ROOT]    ROOT: the folder that stands for /usr (tests/paraview/root.sh); /usr without it
set -euo pipefail
cd "$(dirname "$0")/../.."
source apps/setup.sh
root=${1:-/usr}
prefix=$PWD/build/paraview-prefix

# A build folder that has the tests keeps them.
if [[ ! -e build/release/build.ninja ]]; then
	configure release -DVPROBE_TESTS=OFF -DVPROBE_BENCH=OFF
fi
install_library()
{
	cmake --build build/release --target libvprobe changelog &&
		for component in library development; do
			cmake --install build/release --prefix "$prefix" --component "$component" || return 1
		done
}
step build/log/paraview-library "Installing the library for ParaView" install_library
build_plugin()
{
	cmake -S apps/paraview -B build/paraview -G Ninja -DCMAKE_INSTALL_PREFIX=/usr -DCMAKE_CXX_COMPILER_LAUNCHER=ccache "${strict[@]}" \
		-DCMAKE_PREFIX_PATH="$prefix" -DParaView_DIR="$root/lib/$(dpkg-architecture -qDEB_HOST_MULTIARCH)/cmake/paraview-5.11" &&
		cmake --build build/paraview
}
step build/log/paraview-plugin "Building the plugin for ParaView" build_plugin
