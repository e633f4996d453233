#!/usr/bin/env bash
# Builds the program, draws with it and runs the tests of the release build in a new root file system of Debian 13
# (tests/fresh_root.sh).
# usage: tests/debian13.sh [--can-run]    --can-run: only says why it cannot, if it cannot
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

suite=trixie
source tests/fresh_root.sh

# The files under version control, as they are now.
git ls-files -z | tar --null -T - -cf - | tar -C "$root/source" -xf -

inside bash /source/apps/demo.sh
inside test -s /source/build/demo-shell.png
inside bash /source/tests/run.sh --release
