#!/usr/bin/env bash
# Builds the program and draws one picture with it. Installs what is missing (Debian 12 and 13, Ubuntu 24.04; as root or
# with sudo).
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
source apps/setup.sh

install_packages "${build_packages[@]}"

# A build folder that has the tests keeps them.
if [[ ! -e build/release/build.ninja ]]; then
	configure release -DVPROBE_TESTS=OFF -DVPROBE_BENCH=OFF
fi
step build/log/build "Building" cmake --build build/release --target vprobe vprobe-read

picture=build/demo-shell.png
build/release/bin/vprobe render demo:shell --normal 0.3 0.5 0.81 --camera 60,25 --range -1.6 1.6 -o "$picture"
say "The picture: $PWD/$picture"
