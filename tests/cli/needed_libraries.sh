#!/usr/bin/env bash
# Fails where a program or library needs VTK or HDF5, itself or through other libraries. Only the programs that read files
# may: loading these libraries takes longer than most cuts, and who embeds the engine should not have to install them.
# The same holds for what opens windows, which vprobe-view alone has, and for cairo, which needs it and comes with the
# first flat picture.
# Prints the libraries that FILE itself names, one a line.
# usage: needed_libraries.sh FILE
set -euo pipefail
file=$1
export LC_ALL=C

named=$(readelf --dynamic "$file" | sed -nE 's/.*\(NEEDED\).*\[(.*)\]/\1/p')
[[ -n $named ]] || { echo "$file: names no library; is it linked dynamically?" >&2; exit 1; }
loaded=$(ldd "$file")

printf '%s\n' "$named"
unwanted='libvtk|libhdf5|libglfw|libX|libxcb|libwayland|libcairo'
if found=$(grep -E "$unwanted" <<<"$named"); then
	printf '%s names:\n%s\n' "$file" "$found" >&2
	exit 1
fi
if found=$(grep -E "$unwanted" <<<"$loaded"); then
	printf '%s names none of these, but loads:\n%s\n' "$file" "$found" >&2
	exit 1
fi
