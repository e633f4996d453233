#!/usr/bin/env bash
# Builds and runs every test: release, sanitizers, format, the other compiler. Installs what is missing (Debian 12 and 13,
# Ubuntu 24.04; as root or with sudo). Ends with the slowest steps and tests, and a line that sums up: N passed, N failed,
# N skipped.
# usage: tests/run.sh [--release|--long]
#   --release: the release build and its tests, nothing else
#   --long: also the tests labelled long, every file compiled alone, Debian 13, ParaView, and the packages installed
# What --long downloads is kept in $VPROBE_CACHE, else in ~/.cache/vprobe; so is SwiftShader, a second Vulkan driver (31 MB).
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
source apps/setup.sh

select=(-LE '^long$') long= others=yes threads=threads
case ${1-} in
'') ;;
--release) others= ;;
--long) select=() long=yes threads=unit && export VPROBE_LONG=1 ;;
*) say "usage: tests/run.sh [--release|--long]"; exit 1 ;;
esac

install_packages "${build_packages[@]}" "${test_packages[@]}"

jobs=$(nproc)
clang=$(command -v clang++-14 || command -v clang++) || clang=
passed=0 failed=0 skipped=() launcher=()
export VPROBE_VALIDATION=1
# The same device everywhere: lavapipe, unless VPROBE_TEST_DEVICE asks for the machine's own.
lavapipe=$(compgen -G '/usr/share/vulkan/icd.d/lvp_icd*.json' | head -n 1) || true
if [[ -n $lavapipe && -z ${VPROBE_TEST_DEVICE-} ]]; then
	export VK_DRIVER_FILES=$lavapipe VK_ICD_FILENAMES=$lavapipe
fi

# check TITLE COMMAND...: passes or fails as a whole.
check()
{
	if step "build/log/${1// /-}" "$@"; then
		passed=$((passed + 1))
	else
		failed=$((failed + 1))
	fi
}

# build PRESET TARGET [OPTION...]
build()
{
	local preset=$1 target=$2
	shift 2
	configure "$preset" -DVPROBE_TESTS=ON -DVPROBE_BENCH=ON "$@" &&
		step "build/log/$preset-build" "Building $preset" cmake --build "build/$preset" --target "$target" -- -k 0
}

# list_tests PRESET: a line "passed|failed|skipped SECONDS NAME" for every test that ran, as GoogleTest and ctest report them.
list_tests()
{
	local report name status seconds
	for report in "build/$1"/gtest/*.xml; do
		[[ -e $report ]] || continue
		name=$(basename "$report" .xml)
		awk -v program="${name%.[0-9]*}" '
			function attribute(key)
			{
				return match($0, " " key "=\"[^\"]*\"") ? substr($0, RSTART + length(key) + 3, RLENGTH - length(key) - 4) : ""
			}
			function tell() { if (test) print verdict, seconds, test }
			/<testcase / {
				tell()
				test = program "." attribute("classname") "." attribute("name")
				seconds = attribute("time")
				verdict = attribute("result") == "skipped" ? "skipped" : "passed"
			}
			/<failure / { verdict = "failed" }
			END { tell() }' "$report"
	done
	# Of a program that died before it could report, ctest knows.
	sed -nE 's/.*<testcase name="([^"]*)".* time="([^"]*)" status="([^"]*)".*/\3 \2 \1/p' "build/$1/tests.xml" |
		sed -E 's/^run /passed /; s/^fail /failed /; s/^(notrun|disabled) /skipped /' |
		while read -r status seconds name; do
			[[ -e build/$1/gtest/$name.xml ]] || echo "$status $seconds $name"
		done
}

# run_ctest PRESET JOBS [CTEST OPTION...]
run_ctest()
{
	local preset=$1 at_once=$2 report=build/$1/tests.xml
	shift 2
	rm -rf "$report" "build/$preset/gtest"
	step "build/log/$preset-tests" "Testing $preset" "${launcher[@]}" ctest --test-dir "build/$preset" -j "$at_once" --output-on-failure --timeout 300 \
		--no-tests=error --output-junit "$PWD/$report" "${select[@]}" "$@"
}

# run_tests PRESET [CTEST OPTION...]
run_tests()
{
	local status=0
	run_ctest "$1" "$jobs" "${@:2}" || status=$?
	count_tests "$1" "$status"
}

# count_tests PRESET STATUS: counts passed and failed, keeps the names of the skipped.
count_tests()
{
	local preset=$1 status=$2 report=build/$1/tests.xml total fails names name
	if [[ ! -e $report ]]; then
		failed=$((failed + 1))
		return
	fi
	list_tests "$preset" >"build/$preset/tests.txt"
	total=$(grep -c . "build/$preset/tests.txt" || true)
	fails=$(grep -c '^failed ' "build/$preset/tests.txt" || true)
	mapfile -t names < <(sed -n 's/^skipped [^ ]* //p' "build/$preset/tests.txt")
	((status == 0 || fails > 0)) || fails=1 # ctest itself failed, or a program after its last test
	passed=$((passed + total - fails - ${#names[@]}))
	failed=$((failed + fails))
	for name in "${names[@]}"; do skipped+=("$preset: $name"); done
}

# Names the files that clang-format would change.
check_format()
{
	find engine apps tests shaders/shared -name '*.cpp' -o -name '*.h' -o -name '*.inl' |
		xargs -d '\n' -P "$jobs" -n 100 clang-format-14 --dry-run -Werror
}

# check_with_clang PRESET [TARGET]: the warnings of the other compiler, for all that the preset's build would compile but what
# it compiles for the target. With ccache it makes objects, which nobody links: what has not changed is not compiled again.
check_with_clang()
{
	local preset=$1 compile="$clang -fsyntax-only" end='' ccache
	if ccache=$(command -v ccache); then
		compile="$ccache $clang" end=' -O0 -g0 -fno-sanitize=all'
	fi
	{
		ninja -C "build/$preset" -t commands "${@:2}" | grep -E ' -c [^ ]+$' | sort -u
		ninja -C "build/$preset" -t commands | grep -E ' -c [^ ]+$' | sort -u
	} | if (($# > 1)); then sort | uniq -u; else sort -u; fi |
		sed -E "s#^.*/(c|g|clang)\+\+(-[0-9]+)? #$compile -Wall -Wextra -Werror #; s# -MD -MT [^ ]+ -MF [^ ]+ # #
			s# -o ([^ ]+) -c # -o clang/\1$end -c #; s# --param=[^ ]+##g" >"build/$preset/clang.txt"
	(
		cd "build/$preset"
		sed -E 's#.* -o ([^ ]+)/[^ ]+ .*#\1#' clang.txt | sort -u | xargs -d '\n' mkdir -p
		xargs -d '\n' -P "$jobs" -I COMMAND bash -c 'COMMAND' <clang.txt
	)
}

# Files that are compiled together could lean on each other's includes.
compile_files_alone()
{
	cmake --preset dev -DVPROBE_TESTS=ON -DVPROBE_BENCH=ON && cmake --build build/dev --target vp_shaders vp_font &&
		check_with_clang dev
}

# print_slowest TITLE: the five largest of the lines "SECONDS NAME" on standard input.
print_slowest()
{
	echo "$1:"
	sort -rn | sed -nE '1,5s/^([0-9.]+) /  \1 s  /p' # reads to the end: a sort that cannot write would end the run
}

# Where the kernel has not all of the reader's sandbox (SECURITY.md), vprobe says so in a line, which tests of quiet runs
# would take for a fault.
check_sandbox()
{
	local sample=build/sandbox.vtk
	printf '%s\n' '# vtk DataFile Version 3.0' sample ASCII 'DATASET STRUCTURED_POINTS' 'DIMENSIONS 2 2 2' 'ORIGIN 0 0 0' \
		'SPACING 1 1 1' >"$sample"
	if build/release/bin/vprobe info "$sample" 2>&1 | grep -q 'sandbox is not complete'; then
		export VPROBE_SANDBOX=off
		skipped+=("sandbox: the kernel has not all of it")
	fi
}

test_release()
{
	if build release all; then
		check_sandbox
		run_tests release
	else
		failed=$((failed + 1))
	fi
}

# On one core, so the address sanitizer's tests run beside it. What it says comes when both are done.
test_threads()
{
	# TBB is one of the libraries that the sanitizer does not see into: not that the end of a loop waits for its bodies. On
	# one core TBB starts no threads of its own, while those of the program and its tests run as ever.
	local start=$SECONDS status=0 core
	core=$(taskset -cp "$BASHPID" | sed 's/.*: *\([0-9]*\).*/\1/')
	launcher=(taskset -c "$core")
	TSAN_OPTIONS="suppressions=$PWD/tests/tsan.supp" run_ctest tsan 1 -L "^$threads\$" 2>build/log/tsan-beside || status=$?
	echo $((SECONDS - start)) >build/log/tsan-seconds
	return "$status"
}

# Where clang has its sanitizers it builds with them, which compiles faster than GCC; so it sees most files anyway.
test_with_sanitizers()
{
	local compiler=() seen=() status=0
	beside=
	if [[ -n $clang ]] && "$clang" -x c++ -fsanitize=address,undefined -o build/sanitized - <<<'int main() {}' 2>/dev/null; then
		compiler=(-DCMAKE_CXX_COMPILER="$clang") seen=(cpu_tests)
	fi
	# Libraries are not built for the thread sanitizer, so only threads of our own can be watched (see vp_test).
	if build tsan "${threads}_tests" "${compiler[@]}"; then
		set -m # in a process group of its own, so that it ends with this script
		test_threads &
		beside=$!
		set +m
		trap 'kill -- "-$beside" 2>/dev/null || true' EXIT
	else
		failed=$((failed + 1))
	fi
	if build asan cpu_tests "${compiler[@]}"; then
		run_tests asan -L '^cpu$'
	else
		failed=$((failed + 1))
	fi
	if [[ -n $beside ]]; then
		wait "$beside" || status=$?
		trap - EXIT
		cat build/log/tsan-beside >&2
		step_times+=("$(<build/log/tsan-seconds) Testing tsan, beside asan")
		count_tests tsan "$status"
	fi
	if [[ -z $clang ]]; then
		skipped+=("clang: no clang++-14, no clang++")
	else
		check "The rest with clang" check_with_clang asan "${seen[@]}"
	fi
}

test_at_length()
{
	local why_not tbb
	if [[ -n $clang ]]; then
		check "Files alone with clang" compile_files_alone
	fi
	if ! command -v clang++-14 >/dev/null; then
		skipped+=("fuzz: no clang++-14")
	elif build fuzz fuzz_parsers_guided; then
		run_tests fuzz -R '^fuzz\.parser'
	else
		failed=$((failed + 1))
	fi
	# Here the sanitizer sees into TBB, which may start threads of its own then. It does not see into VTK's loops, which
	# unit_read has many of.
	bash tests/tsan_tbb.sh --fetch >/dev/null 2>build/log/tsan-tbb-fetch || true
	if tbb=$(bash tests/tsan_tbb.sh); then
		if build tsan-tbb unit_tests -DCMAKE_CXX_COMPILER="$clang" -DTBB_DIR="$tbb/lib/cmake/TBB"; then
			LD_LIBRARY_PATH=$tbb/lib run_tests tsan-tbb -L '^unit$' -E '^unit_read'
		else
			failed=$((failed + 1))
		fi
	else
		skipped+=("threads on several cores: $tbb")
	fi
	if why_not=$(bash tests/debian13.sh --can-run); then
		check "Debian 13" bash tests/debian13.sh
	else
		skipped+=("Debian 13: $why_not")
	fi
	bash tests/paraview/root.sh --fetch >/dev/null 2>&1 || true
	if why_not=$(bash tests/paraview/run.sh --can-run); then
		check "ParaView" bash tests/paraview/run.sh
	else
		skipped+=("ParaView: $why_not")
	fi
	if why_not=$(bash tests/package/installed.sh --can-run); then
		check "Packages installed" bash tests/package/installed.sh
	else
		skipped+=("packages installed: $why_not")
	fi
}

test_format()
{
	if command -v clang-format-14 >/dev/null; then
		check "Format" check_format
	else
		skipped+=("format: no clang-format-14")
	fi
}

# Names the tests that failed, and what they said first: logs are long, and a server may keep the end alone.
print_failures()
{
	local report preset
	for report in build/*/tests.txt; do
		preset=$(basename "$(dirname "$report")")
		grep -q '^failed ' "$report" 2>/dev/null || continue
		sed -n "s/^failed [^ ]* /failed: $preset: /p" "$report"
		grep -hE -A 6 '^E  |: Failure$|^(SUMMARY|WARNING): [A-Za-z]*Sanitizer|Failed .*sec$' "build/log/$preset-tests" | head -n 60 || true
	done
}

# Without it its tests are skipped, by name.
bash tests/devices/swiftshader.sh --fetch || true

rm -f build/*/tests.txt
test_release
if [[ -n $others ]]; then
	test_with_sanitizers
	test_format
fi
if [[ -n $long ]]; then
	test_at_length
fi

printf '%s\n' "${step_times[@]}" | print_slowest "Slowest steps"
{ cat build/*/tests.txt 2>/dev/null || true; } | sed 's/^[a-z]* //' | print_slowest "Slowest tests"
print_failures
printf 'skipped: %s\n' "${skipped[@]}" | sed '/^skipped: $/d'
printf '%s\n' "${skipped[@]}" >build/skipped.txt
echo "$passed passed, $failed failed, ${#skipped[@]} skipped"
((failed == 0))
