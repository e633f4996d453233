#!/usr/bin/env bash
# Runs the steps of docs/Containerfile in a new root file system of Debian 12 (tests/fresh_root.sh), with the package of a
# build, and then draws and judges a picture there.
# usage: tests/container.sh [--can-run] [PACKAGES]
#   PACKAGES: the folder with vprobe_*.deb; by default build/packages    --can-run: only says why it cannot, if it cannot
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

suite=bookworm
packages=build/packages
for argument in "$@"; do
	[[ $argument == --can-run ]] || packages=$argument
done
source tests/fresh_root.sh

shopt -s nullglob
given=("$packages"/vprobe_*.deb)
if ((${#given[@]} != 1)); then
	echo "$packages: holds no package, or several; make one by docs/INSTALL.md"
	exit 1
fi
cp "${given[0]}" "$root/tmp/"
step=$(sed -n 's/^RUN //p' docs/Containerfile)
inside sh -c "$step"
entry=$(sed -n 's/^ENTRYPOINT \["\(.*\)"\]$/\1/p' docs/Containerfile)
mkdir "$root/views"
inside "$entry" render demo:shell:16 --normal x --size 320x240 --save /views/x.json -o /views/x.png
inside "$entry" verify --update /views
inside "$entry" verify /views --junit /views/junit.xml
echo "packages: $(inside dpkg-query -W | wc -l), $(inside du -sxm / --exclude=/proc --exclude=/sys | cut -f1) MB in all"
