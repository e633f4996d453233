# shellcheck shell=bash disable=SC2034
# What apps/demo.sh and tests/run.sh share: the packages of Debian 12, their installation, steps with progress.
# Sourced, never run.

build_packages=(
	cmake ninja-build g++ glslang-tools glslang-dev spirv-tools
	libvulkan-dev libvtk9-dev libtbb-dev libglm-dev libfmt-dev libspdlog-dev libcli11-dev nlohmann-json3-dev
	libteem-dev zlib1g-dev libpng-dev libcairo2-dev pkg-config libimgui-dev libstb-dev libglfw3-dev fonts-dejavu-core
	mesa-vulkan-drivers # lavapipe draws where there is no GPU
)
test_packages=(
	ccache clang-14 clang-format-14 libgtest-dev libgmock-dev libbenchmark-dev libmuparser-dev vulkan-validationlayers
	xvfb xdotool openbox
)

# Another compiler has other warnings: they are errors on Debian 12 only.
strict=()
if (. /etc/os-release && [[ $ID$VERSION_ID == debian12 ]]) 2>/dev/null; then
	strict=(-DCMAKE_COMPILE_WARNING_AS_ERROR=ON)
fi

say() { printf '%s\n' "$*" >&2; }

# step LOG TITLE COMMAND...: one line of progress; what the command says goes to LOG and is shown where it fails.
step()
{
	local log=$1 title=$2 start=$SECONDS status=0 line
	shift 2
	mkdir -p "$(dirname "$log")"
	if [[ -t 2 ]]; then
		"$@" </dev/null 2>&1 | tee "$log" | while IFS= read -r line; do
			printf '\r\e[K%s: %.*s' "$title" $((${COLUMNS:-80} - ${#title} - 3)) "$line" >&2
		done || status=$?
		printf '\r\e[K' >&2
	else
		say "$title ..."
		"$@" </dev/null >"$log" 2>&1 || status=$?
	fi
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

# install_packages PACKAGE...: on Debian 12, installs what is missing; elsewhere says what is needed and goes on.
install_packages()
{
	local missing=("$@") as_root=()
	if command -v dpkg-query >/dev/null; then
		mapfile -t missing < <(missing_packages "$@")
		((${#missing[@]})) || return 0
	fi
	((EUID)) && as_root=(sudo)
	if ((${#strict[@]} == 0)); then
		say "Needed, by the names of Debian 12: ${missing[*]}"
	elif ((EUID)) && ! command -v sudo >/dev/null; then
		say "Missing, and neither root nor sudo to install it: apt-get install ${missing[*]}"
	else
		local apt=("${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -qq -o DPkg::Lock::Timeout=300)
		((EUID)) && sudo -v
		step build/log/apt-update "Package lists" "${apt[@]}" update
		step build/log/apt-install "Installing ${#missing[@]} packages and what they need" \
			"${apt[@]}" install -y --no-install-recommends "${missing[@]}"
		return
	fi
	local tool
	for tool in cmake ninja c++; do
		command -v "$tool" >/dev/null || { say "$tool is not there: install the packages named above."; return 1; }
	done
}
