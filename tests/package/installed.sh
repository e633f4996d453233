#!/usr/bin/env bash
# Installs the packages in a new root file system of this Debian (tests/fresh_root.sh), draws with them, opens a page of
# the manual, builds a program against the library, and removes all again.
# usage: tests/package/installed.sh [--can-run]    --can-run: only says why it cannot, if it cannot
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."

suite=$(. /etc/os-release && echo "${VERSION_CODENAME-}")
source tests/fresh_root.sh

bash apps/package.sh "$root/packages"
cp tests/embed/slice_own_grid.cpp "$root/packages"
install=(env DEBIAN_FRONTEND=noninteractive apt-get -qq -y --no-install-recommends install)
inside apt-get -qq update
inside "${install[@]}" man-db g++ pkg-config mesa-vulkan-drivers >/dev/null
packages=("$root"/packages/*.deb)
inside "${install[@]}" "${packages[@]#"$root"}" >/dev/null
inside vprobe render demo:shell:32 --normal 0.3 0.5 0.8 -o /tmp/picture.png
inside test -s /tmp/picture.png
cat >"$root/tmp/cut.vti" <<'END'
<VTKFile type="ImageData" version="1.0" byte_order="LittleEndian">
<ImageData WholeExtent="0 1 0 1 0 1" Origin="0 0 0" Spacing="1 1 1"><Piece Extent="0 1 0 1 0 1">
<PointData><DataArray type="Float32" Name="p" format="ascii">1 2 3 4 5 6 7 8</DataArray></PointData>
</Piece></ImageData></VTKFile>
END
inside man vprobe-render | grep -q 'vprobe-render'
inside sh -c 'g++ /packages/slice_own_grid.cpp -o /tmp/slice $(pkg-config --cflags --libs vprobe) && /tmp/slice' |
	grep -q '^[1-9][0-9]* polygons'
inside python3 -c 'import vprobe; s = vprobe.open("/tmp/cut.vti").slice(); assert s.area > 0; print(s)'
{ inside vprobe view 2>&1 || true; } | grep -q DISPLAY # no screen here
inside apt-get -qq -y purge vprobe vprobe-view libvprobe0 libvprobe-dev python3-vprobe >/dev/null
left=$(inside sh -c 'find / -xdev -path /proc -prune -o -name "*vprobe*" -print' | grep -vE '^/(packages|tmp|source|var)' || true)
[[ -z $left ]] || { echo "left after removal: $left"; exit 1; }
echo "installed, used and removed"
