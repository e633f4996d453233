#!/bin/sh
# Installs the library into a scratch prefix, builds this project against it with CMake, and once more with pkg-config
# and the compiler alone, and runs what was built.
# usage: run.sh BUILD_FOLDER SOURCE_FOLDER SCRATCH_FOLDER C++_COMPILER
set -eu
build=$1 source=$2 scratch=$3 compiler=$4
rm -rf "$scratch"
mkdir -p "$scratch"
cmake --install "$build" --prefix "$scratch/prefix" > "$scratch/install.log"
cmake -S "$source" -B "$scratch/build" -DCMAKE_PREFIX_PATH="$scratch/prefix" -DCMAKE_CXX_COMPILER="$compiler" \
	-DCMAKE_BUILD_TYPE=Debug > "$scratch/configure.log"
cmake --build "$scratch/build" > "$scratch/build.log" || { cat "$scratch/build.log"; exit 1; }

library=$(dirname "$(find "$scratch/prefix" -name libvprobe.so)")
export LD_LIBRARY_PATH="$library"
PKG_CONFIG_PATH=$library/pkgconfig
export PKG_CONFIG_PATH
# What pkg-config gives are words.
# shellcheck disable=SC2046
"$compiler" "$source/slice_own_grid.cpp" -o "$scratch/by_hand" $(pkg-config --cflags --libs vprobe)

"$scratch/build/slice_own_grid" | tee "$scratch/slice.txt"
grep -q "^[1-9][0-9]* polygons, area" "$scratch/slice.txt"
"$scratch/by_hand" | cmp - "$scratch/slice.txt"
"$scratch/build/sweep_frames" | tee "$scratch/sweep.txt"
grep -q "^8 frames were looked at" "$scratch/sweep.txt"
"$scratch/build/draw_picture" demo:shell:24 "$scratch/picture.png"
head -c 8 "$scratch/picture.png" | od -An -c | grep -q "P   N   G"
# A file is read by the program that was installed with the library.
"$scratch/prefix/bin/vprobe" slice demo:tets:4 -o "$scratch/cut.vtp"
! "$scratch/build/draw_picture" "$scratch/cut.vtp" "$scratch/none.png" 2> "$scratch/refused.txt"
grep -q "cut.vtp" "$scratch/refused.txt"
