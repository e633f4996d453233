#!/usr/bin/env bash
# Copies the pictures that the tests took of the window into docs/viewer.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
for name in shell trihedral plane start hint find_command color_map; do
	cp "build/release/tests/view/pictures/$name.png" docs/viewer/
done
