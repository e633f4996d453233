# shellcheck shell=bash disable=SC2034
# What apps/demo.sh and tests/run.sh share: package names, their installation, steps with progress.
# Sourced, never run.

# ID and version of the system, such as debian12; empty where it does not say.
system=$(. /etc/os-release 2>/dev/null && printf '%s%s' "${ID-}" "${VERSION_ID-}") || system=

# ccache serves the second build, not the first; it is here so that both scripts compile with the same commands.
build_packages=(
	cmake ninja-build g++ ccache glslang-tools glslang-dev spirv-tools
	libvulkan-dev libvtk9-dev libtbb-dev libglm-dev libfmt-dev libutfcpp-dev libcli11-dev nlohmann-json3-dev
	libteem-dev libtiff-dev libhdf5-dev libgdcm-dev zlib1g-dev libblosc-dev libdeflate-dev liblz4-dev liblzma-dev libzstd-dev libexpat1-dev libpng-dev libcairo2-dev pkg-config libimgui-dev libstb-dev libglfw3-dev libx11-dev libxrandr-dev fonts-dejavu-core
	mesa-vulkan-drivers # lavapipe draws where there is no GPU
)
# What the Python module is built with. A program without one needs none of it.
python_packages=(python3-dev python3-numpy pybind11-dev)
# What vprobe-mpi is built with and run by. The other programs need none of it.
cluster_packages=(libopenmpi-dev openmpi-bin)
test_packages=(
	"${python_packages[@]}" "${cluster_packages[@]}" python3-pytest python3-vtk9 mypy python3-ipywidgets python3-nbclient python3-ipykernel
	python3-build python3-venv python3-setuptools python3-wheel
	libgtest-dev libgmock-dev libbenchmark-dev libmuparser-dev vulkan-validationlayers
	xvfb xdotool openbox
	python3 dpkg-dev file # documents are checked, packages are made
	python3-meshio python3-h5py gmsh python3-gmsh python3-netcdf4 python3-xarray python3-zarr python3-tifffile python3-mrcfile python3-pydicom
	python3-nibabel python3-segyio dcm2niix libgdcm-tools # they write files of other formats
	ffmpeg # films are tested where they can be made
)
# The plugin for ParaView 5.11, which Debian 12 has: its icon and help want Qt's tools.
paraview_packages=(
	paraview paraview-dev libopenmpi-dev openmpi-bin xvfb dpkg-dev file
	qtbase5-dev qttools5-dev qttools5-dev-tools qtxmlpatterns5-dev-tools
)
# The second compiler. clang-format's output depends on its version, so the format is checked where version 14 is.
case $system in
debian13) test_packages+=(clang) ;;
*) test_packages+=(clang-14 libclang-rt-14-dev clang-format-14) ;;
esac

# The scripts install packages on these. Ubuntu has the same names in its package lists; nobody has run the scripts there.
case $system in
debian12 | debian13 | ubuntu24.04) can_install=yes ;;
*) can_install= ;;
esac

# Another compiler has other warnings: they are errors only where the project is tested.
strict=()
case $system in
debian12 | debian13) strict=(-DCMAKE_COMPILE_WARNING_AS_ERROR=ON) ;;
esac

# Objects are shared between checkouts.
export CCACHE_BASEDIR=$PWD CCACHE_NOHASHDIR=1

step_times=() # "SECONDS TITLE" of each step

say() { printf '%s\n' "$*" >&2; }

# report_progress LOG TITLE: every 30 seconds, a line that says how far ninja, or ctest, has come by its log.
report_progress()
{
	local log=$1 title=$2 start=$SECONDS spent count nap=
	trap 'kill "$nap" 2>/dev/null; exit' TERM
	while true; do
		sleep 30 &
		nap=$!
		wait "$nap"
		spent=$((SECONDS - start))
		# "[12/340] Building ..." and " 12/340 Test ..."
		count=$(tail -c 20000 "$log" | sed -nE 's#^(\[| *)([0-9]+/[0-9]+)(\]| Test).*#\2#p' | tail -n 1) || true
		if [[ $count == [1-9]* ]]; then
			say "$title: ${count%/*} of ${count#*/} done, about $((spent * (${count#*/} - ${count%/*}) / ${count%/*})) s left"
		else
			say "$title: $spent s so far"
		fi
	done
}

# step LOG TITLE COMMAND...: on a terminal one line of progress that is renewed, elsewhere a line every 30 seconds. The
# command's output goes to LOG and is shown where it fails.
step()
{
	local log=$1 title=$2 start=$SECONDS status=0 line reporter
	shift 2
	mkdir -p "$(dirname "$log")"
	if [[ -t 2 ]]; then
		"$@" </dev/null 2>&1 | tee "$log" | while IFS= read -r line; do
			printf '\r\e[K%s: %.*s' "$title" $((${COLUMNS:-80} - ${#title} - 3)) "$line" >&2
		done || status=$?
		printf '\r\e[K' >&2
	else
		say "$title ..."
		: >"$log"
		report_progress "$log" "$title" >/dev/null &
		reporter=$!
		"$@" </dev/null >"$log" 2>&1 || status=$?
		kill "$reporter" 2>/dev/null || true
		wait "$reporter" 2>/dev/null || true
	fi
	step_times+=("$((SECONDS - start)) $title")
	if ((status)); then
		grep -vE '^\[[0-9]+/[0-9]+\] [A-Z]' "$log" | tail -n 200 >&2 || true # ninja's good lines left out
		say "$title: failed; all of it is in $log"
	else
		say "$title: done in $((SECONDS - start)) s"
	fi
	return "$status"
}

# missing_packages PACKAGE...: those that are not installed.
missing_packages()
{
	comm -13 <(dpkg-query -W -f '${db:Status-Status} ${Package}\n' "$@" 2>/dev/null | sed -n 's/^installed //p' | sort -u) \
		<(printf '%s\n' "$@" | sort -u)
}

# install_packages PACKAGE...: installs what is missing where the names are known; elsewhere says in one line what the
# build needs and does not find, and goes on where it finds all of it.
install_packages()
{
	local missing=() as_root=() tool
	if [[ -z $can_install ]]; then
		for tool in cmake ninja c++ glslangValidator pkg-config; do
			command -v "$tool" >/dev/null || missing+=("$tool")
		done
		((${#missing[@]})) || return 0
		say "This system's packages are not known here. Missing: ${missing[*]}. docs/INSTALL.md lists what the build needs."
		return 1
	fi
	mapfile -t missing < <(missing_packages "$@")
	((${#missing[@]})) || return 0
	if ((EUID)) && ! command -v sudo >/dev/null; then
		say "Missing, and neither root nor sudo to install it: apt-get install ${missing[*]}"
		return 1
	fi
	((EUID)) && as_root=(sudo) && sudo -v
	local apt=("${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -qq -o DPkg::Lock::Timeout=300)
	step build/log/apt-update "Package lists" "${apt[@]}" update
	step build/log/apt-install "Installing ${#missing[@]} packages and what they need" \
		"${apt[@]}" install -y --no-install-recommends "${missing[@]}"
}

# configure PRESET [OPTION...]: with the same compile commands for every script, so nothing is compiled twice.
configure()
{
	local preset=$1
	shift
	step "build/log/$preset-configure" "Configuring $preset" cmake --preset "$preset" "${strict[@]}" "$@"
}
