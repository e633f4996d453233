#!/usr/bin/env bash
# The functions in which the program spends its time have names for perf, so that a user can see them.
# usage: perf_names.sh VPROBE    Exits with 77 where perf cannot record.
set -euo pipefail

skip()
{
	echo "skipped: $1"
	exit 77
}

command -v perf > /dev/null || skip "perf is not installed"
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
# A cache of symbols could name what the program itself does not.
perf=(perf --buildid-dir "$folder/cache")
record=("${perf[@]}" record --event cpu-clock --freq 1000 --output "$folder/data")
"${record[@]}" true > /dev/null 2>&1 || skip "perf cannot record here"
"${record[@]}" "$1" profile demo:shell:64 --planes 200 --classify cpu --no-floor --json "$folder/profile.json" \
	> /dev/null 2>&1
"${perf[@]}" script --input "$folder/data" --fields ip,sym 2> /dev/null > "$folder/names"

samples=$(grep -c . "$folder/names" || true)
named=$(grep -c 'vp::' "$folder/names" || true)
echo "$named of $samples samples lie in functions of ours"
if (( samples < 20 || 4 * named < samples )); then
	echo "perf script names too few functions:" >&2
	head -n 20 "$folder/names" >&2
	exit 1
fi
for room in vp::find:: vp::mesh::; do
	grep -q "$room" "$folder/names" || { echo "no function of $room is named" >&2; exit 1; }
done
