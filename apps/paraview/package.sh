#!/usr/bin/env bash
# Makes the Debian package paraview-vprobe, and says where it is.
# usage: apps/paraview/package.sh [FOLDER [ROOT]]    FOLDER: where it goes; build/packages without it. ROOT: as for build.sh
set -euo pipefail
target=$(realpath -m "${1:-$(dirname "$0")/../../build/packages}")
cd "$(dirname "$0")/../.."
source apps/setup.sh
bash apps/paraview/build.sh "${2:-/usr}"
mkdir -p "$target"
rm -f "$target"/paraview-vprobe_*.deb
step build/log/paraview-package "Packing" cpack --config build/paraview/CPackConfig.cmake -B "$target"
rm -rf "$target/_CPack_Packages"
ls -1 "$target"/paraview-vprobe_*.deb
