#!/usr/bin/env bash
# Makes docs/sweep.webp, the moving picture of the README: a paddlewheel that turns in half a shell.
# usage: docs/make_sweep.sh [VPROBE]    VPROBE: the program; build/release/bin/vprobe without it. Needs ffmpeg.
set -euo pipefail
cd "$(dirname "$0")/.."
vprobe=${1:-build/release/bin/vprobe}
film=$(mktemp --suffix .mkv)
trap 'rm -f "$film"' EXIT
"$vprobe" sweep demo:shell:96 --probe paddlewheel --path revolve --frames 60 --fps 15 --context boundary \
	--size 720x450 --samples 8 --title "" --device llvmpipe -o "$film"
ffmpeg -y -loglevel error -i "$film" -c:v libwebp_anim -loop 0 -q:v 80 -compression_level 6 docs/sweep.webp
bytes=$(stat -c %s docs/sweep.webp)
((bytes < 2000000)) || { echo "docs/sweep.webp has $bytes bytes; the README wants less than 2 MB" >&2; exit 1; }
