#!/usr/bin/env bash
# Draws a picture, and holds the program to having drawn it on a device of this name.
# usage: draws_on.sh VPROBE NAME
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"$1" render demo:shell:16 --normal 0.3 0.5 0.81 --classify gpu --stats "$folder/stats.json" -o "$folder/picture.png"
grep "\"device\": *\"$2" "$folder/stats.json"
