#!/bin/sh
# Lists what a library exports, and holds it against the list beside this script: nothing but the face in vprobe::, and
# all of it. After a change that is meant: exported_symbols.sh LIBRARY --update
set -eu
list=$(dirname "$0")/exported_symbols.txt
found=$(nm -D --defined-only --demangle "$1" | sed -n 's/^[0-9a-f]* [^A] //p' | sed 's/@@VPROBE_0$//' | LC_ALL=C sort -u)
if [ "${2:-}" = --update ]; then
	printf '%s\n' "$found" > "$list"
fi
if printf '%s\n' "$found" | grep -vE '^((typeinfo|typeinfo name|vtable) for )?vprobe::'; then
	echo "the symbols above are no part of the face" >&2
	exit 1
fi
printf '%s\n' "$found" | diff "$list" - || {
	echo "the exported symbols are others than in $list" >&2
	exit 1
}
printf '%s symbols\n' "$(printf '%s\n' "$found" | wc -l)"
