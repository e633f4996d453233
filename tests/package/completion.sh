#!/usr/bin/env bash
# Completes command lines with the script for bash, as a user's Tab does; checks the syntax of the script for zsh.
# usage: completion.sh FOLDER_OF_VPROBE
set -euo pipefail
export PATH=$1:$PATH
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
vprobe manual --completion bash >"$scratch/vprobe"
source "$scratch/vprobe"
cd "$scratch"
# A file with one array, as any image may be.
cat >cut.vti <<'END'
<VTKFile type="ImageData" version="1.0" byte_order="LittleEndian">
<ImageData WholeExtent="0 1 0 1 0 1" Origin="0 0 0" Spacing="1 1 1"><Piece Extent="0 1 0 1 0 1">
<PointData><DataArray type="Float32" Name="temperature in K" format="ascii">1 2 3 4 5 6 7 8</DataArray></PointData>
</Piece></ImageData></VTKFile>
END

failures=0
# expect WANTED WORD...: the completions of the last word, in lines.
expect()
{
	local wanted=$1 found
	shift
	COMP_WORDS=("$@") COMP_CWORD=$(($# - 1))
	_vprobe
	found=$(printf '%s\n' "${COMPREPLY[@]}")
	if [[ $found != "$wanted" ]]; then
		printf 'vprobe: %s\n  wanted: %s\n  found:  %s\n' "$*" "${wanted//$'\n'/ }" "${found//$'\n'/ }"
		failures=$((failures + 1))
	fi
}
expect render vprobe rend
expect --array vprobe render --arr
expect 'paddlewheel' vprobe render --probe pad
expect $'viridis' vprobe sweep --colormap v
expect $'auto\nhotspot\nboundary' vprobe slice --seeds ''
expect 'temperature in K' vprobe render cut.vti --array ''
expect 'cut.vti' vprobe render cu
expect '' vprobe manua # no part of what a user sees
if command -v zsh >/dev/null; then
	vprobe manual --completion zsh >_vprobe
	zsh -n _vprobe
fi
((failures == 0))
echo "all completions as they should be"
