#!/bin/sh
# Holds the libraries that the library needs by itself against a fixed list, and looks for VTK, HDF5 and what opens
# windows among all that come with them. usage: needed_libraries.sh LIBRARY
set -eu
known="ld-linux-x86-64 libc libfmt libfontconfig libfreetype libgcc_s libm libpng16 libstb libstdc++ libtbb libvulkan"
for needed in $(readelf -d "$1" | sed -n 's/.*(NEEDED).*\[\(.*\)\].*/\1/p'); do
	name=${needed%%.so*}
	case " $known " in
	*" $name "*) ;;
	*)
		echo "$1 needs $needed, which is not on the list: $known" >&2
		exit 1
		;;
	esac
done
if ldd "$1" | grep -E 'libvtk|libhdf5|libglfw|libGL\.|libX|libxcb|libwayland|libcairo'; then
	echo "$1 brings the libraries above" >&2
	exit 1
fi
