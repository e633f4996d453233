#!/usr/bin/env bash
# Builds the plugin for ParaView against the installed library, and tests it in pvbatch, in a server with a client, and
# in a simulation that hands its fields to Catalyst. Each script prints a line for each check.
# usage: tests/paraview/run.sh [--can-run]    --can-run: only says why it cannot, if it cannot
# Needs build/release. Leaves data, results and pictures in build/paraview-test.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
project=$PWD

root=$(tests/paraview/root.sh 2>&1) || { echo "${root##*$'\n'}"; exit 1; }
for tool in Xvfb rcc qhelpgenerator xmlpatterns mpicxx; do
	command -v "$tool" >/dev/null || { echo "no $tool; tests/paraview/root.sh --fetch installs it"; exit 1; }
done
[[ ${1-} != --can-run ]] || exit 0

source apps/setup.sh
build=$project/build/paraview
bash apps/paraview/package.sh build/paraview-package "$root" >/dev/null

failed=0

# The package: what is in it, and what it is bound to.
deb=$(echo build/paraview-package/paraview-vprobe_*.deb)
contents=$(dpkg-deb -c "$deb" | sed -nE 's#.* \./(usr/[^ ]*[^/ ])$#\1#p' | sed "s#$(dpkg-architecture -qDEB_HOST_MULTIARCH)#TRIPLET#" | sort)
if diff <(echo "$contents") tests/paraview/contents.txt &&
	dpkg-deb -f "$deb" Depends | grep -qE '^libvprobe0 \(= .*\), paraview \(>= 5\.11.*\), paraview \(<< 5\.12\)'; then
	echo "ok: the package $(basename "$deb")"
else
	echo "FAILED: the package $(basename "$deb")"
	failed=1
fi
# Neither Debian's VTK nor HDF5 comes with it.
libraries=$(objdump -p "$build"/lib/*/paraview-5.11/plugins/VolumeProbes/*.so | sed -n 's/ *NEEDED *//p' | sort -u)
if grep -qE 'hdf5|-9\.[0-9]+\.so' <<<"$libraries" || ! grep -q 'libvprobe\.so\.0' <<<"$libraries"; then
	echo "FAILED: the plugin links ${libraries//$'\n'/ }"
	failed=1
fi

# Processes of one machine may run as root here, which containers do, and more of them than there are cores.
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 OMPI_MCA_rmaps_base_oversubscribe=1
export VPROBE_SCRATCH=$project/build/paraview-test
# The plugin of the package, as it would be installed, with the library beside it.
rm -rf "$VPROBE_SCRATCH"
mkdir -p "$VPROBE_SCRATCH/installed"
dpkg -x "$deb" "$VPROBE_SCRATCH/installed"
cp -P build/paraview-prefix/lib*/libvprobe.so.* "$(echo "$VPROBE_SCRATCH"/installed/usr/lib/*/paraview-5.11)/.."
export VPROBE_PLUGIN
VPROBE_PLUGIN=$(echo "$VPROBE_SCRATCH"/installed/usr/lib/*/paraview-5.11/plugins/VolumeProbes/VolumeProbes.so)
[[ $root == /usr ]] || export PYTHONPATH=$root/lib/python3/dist-packages
scripts=$project/tests/paraview

# One X server, which finds a free number itself: xvfb-run can meet another that starts at the same time. It does not start
# anew when its last client leaves: the next one would meet it then.
Xvfb -displayfd 1 -screen 0 1280x1024x24 -nolisten tcp -noreset >"$VPROBE_SCRATCH/display.txt" 2>/dev/null &
server=$!
trap 'kill "$server" 2>/dev/null' EXIT
timeout 20 bash -c "until [[ -s '$VPROBE_SCRATCH/display.txt' ]]; do sleep .1; done"
DISPLAY=:$(<"$VPROBE_SCRATCH/display.txt")
export DISPLAY

# batch RANKS SCRIPT: what it prints is kept.
batch()
{
	local log=$VPROBE_SCRATCH/${2%.py}-$1.txt
	local status=0
	timeout 300 mpiexec -n "$1" pvbatch "$scripts/$2" >"$log" 2>&1 || status=$?
	grep -E '^(ok|FAILED|case|Traceback|[A-Z][a-zA-Z]*Error)|cells, ' "$log" || true
	((status == 0)) || { echo "FAILED: $2 on $1 ranks ended with $status"; failed=1; }
}

batch 1 make_data.py
batch 2 make_data.py
for ranks in 1 2 3; do batch "$ranks" slice.py; done
for ranks in 1 2; do batch "$ranks" options.py; done
batch 1 kinds.py
batch 1 progress.py

# Errors of the filter, after each heading that says how many there are to be.
batch 2 faults.py
awk '/^case: /{ if (wanted != "" && told != wanted) bad = 1; wanted = $(NF - 1); told = 0 }
	/ERR.*vtkVolumeProbe/{ ++told } END { exit bad }' "$VPROBE_SCRATCH/faults-2.txt" ||
	{ echo "FAILED: not as many errors as there should be"; failed=1; }

# serve OPTION...: a server of two ranks, and a client that drags; the server ends with its client.
serve()
{
	local log=$VPROBE_SCRATCH/server.txt port=$((20000 + RANDOM % 20000)) pvserver
	mpiexec -n 2 pvserver --server-port="$port" >"$log" 2>&1 &
	pvserver=$!
	timeout 60 bash -c "until grep -q 'Accepting connection' '$log'; do sleep .1; done" || failed=1
	timeout 200 "$root/bin/pvpython" "$scripts/drag.py" "$port" "$@" 2>&1 |
		grep -E '^(ok|FAILED|Traceback|[A-Z][a-zA-Z]*Error)' || true
	if timeout 30 tail --pid="$pvserver" -f /dev/null; then
		echo "ok: the server ends with its client ($*)"
	else
		echo "FAILED: the server hangs ($*)"
		kill "$pvserver"
		failed=1
	fi
}

serve >"$VPROBE_SCRATCH/drag.txt"
cat "$VPROBE_SCRATCH/drag.txt"
grep -q 'misses' "$VPROBE_SCRATCH/drag.txt" || { echo "FAILED: the client did not come to its end"; failed=1; }
! grep -q FAILED "$VPROBE_SCRATCH/drag.txt" || failed=1
serve --leave-at-once

# A program of its own, as a simulation is. ParaView's CMake files look for none of what these libraries link.
linked=(sys PythonInterpreter PVCatalyst PVPythonCatalyst CommonCore CommonDataModel)
linked=("${linked[@]/#/-lvtk}")
mpicxx -std=c++20 -O1 -Wall -Wextra -Werror -DOMPI_SKIP_MPICXX -isystem /usr/include/paraview-5.11 "$scripts/steps.cpp" \
	-o "$VPROBE_SCRATCH/steps" "${linked[@]/%/-pv5.11}" "$(echo /usr/lib/*/libpython3.11.so.1.0)"
timeout 200 mpiexec -n 2 "$VPROBE_SCRATCH/steps" "$scripts/catalyst.py" 6 >"$VPROBE_SCRATCH/catalyst.txt" 2>&1 ||
	failed=1
for rank in 0 1; do
	read -r step grids neighbors cuts _ < <(tail -n 1 "$VPROBE_SCRATCH/steps-$rank.txt") || true
	verdict=FAILED
	[[ $step == 5 && $grids == 1 && $neighbors == 1 && -s $VPROBE_SCRATCH/step-5.png ]] && verdict=ok || failed=1
	echo "$verdict: Catalyst, rank $rank: a picture at each of 6 steps, $cuts cuts, neighbors built $neighbors time"
done
! cmp -s "$VPROBE_SCRATCH/step-0.png" "$VPROBE_SCRATCH/step-5.png" || { echo "FAILED: all steps look the same"; failed=1; }
((failed == 0))
