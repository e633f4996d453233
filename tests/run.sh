#!/usr/bin/env bash
# Builds and runs every test: release, sanitizers, format, the other compiler. Installs what is missing (Debian 12, as root
# or with sudo). The last line sums up: N passed, N failed, N skipped.
# usage: tests/run.sh [--long]    --long: the tests labelled long as well
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
source apps/setup.sh

select=(-LE '^long$') long=
case ${1-} in
'') ;;
--long) select=() long=yes ;;
*) say "usage: tests/run.sh [--long]"; exit 1 ;;
esac

install_packages "${build_packages[@]}" "${test_packages[@]}"

jobs=$(nproc)
passed=0 failed=0 skipped=() launcher=()
# Objects are shared between checkouts.
export CCACHE_BASEDIR=$PWD CCACHE_NOHASHDIR=1
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
	step "build/log/$preset-configure" "Configuring $preset" \
		cmake --preset "$preset" -DVPROBE_TESTS=ON -DVPROBE_BENCH=ON "${strict[@]}" "$@" &&
		step "build/log/$preset-build" "Building $preset" cmake --build "build/$preset" --target "$target" -- -k 0
}

# run_tests PRESET [CTEST OPTION...]: counts passed and failed, keeps the names of the skipped.
run_tests()
{
	local preset=$1 report=build/$1/tests.xml status=0 total fails names name
	shift
	rm -f "$report"
	step "build/log/$preset-tests" "Testing $preset" "${launcher[@]}" ctest --test-dir "build/$preset" -j "$jobs" --output-on-failure --timeout 300 \
		--no-tests=error --output-junit "$PWD/$report" "${select[@]}" "$@" || status=$?
	if [[ ! -e $report ]]; then
		failed=$((failed + 1))
		return
	fi
	total=$(grep -c '<testcase ' "$report" || true)
	fails=$(grep -c '<testcase .*status="fail"' "$report" || true)
	mapfile -t names < <(sed -n 's/.*<testcase name="\([^"]*\)".*status="\(notrun\|disabled\)".*/\1/p' "$report")
	((status == 0 || fails > 0)) || fails=1 # ctest itself failed
	passed=$((passed + total - fails - ${#names[@]}))
	failed=$((failed + fails))
	for name in "${names[@]}"; do skipped+=("$preset: $name"); done
}

# Names the files that clang-format would change.
check_format()
{
	local file bad=0
	while IFS= read -r file; do
		clang-format-14 "$file" | cmp -s - "$file" || { echo "$file: clang-format-14 -i would change it"; bad=1; }
	done < <(find engine apps tests shaders/shared -name '*.cpp' -o -name '*.h' -o -name '*.inl')
	return "$bad"
}

# Every source file, compiled as the release build does, with the warnings of the other compiler.
compile_with_clang()
{
	sed -n 's/^ *"command": "\(.*\)",\{0,1\}$/\1/p' build/release/compile_commands.json | sed 's/\\"/"/g; s/\\\\/\\/g' |
		sed -E 's#^.*/(c|g)\+\+(-[0-9]+)? #clang++-14 -fsyntax-only -Wall -Wextra -Werror #; s# -o [^ ]+ # #' | sort |
		(cd build/release && xargs -d '\n' -P "$jobs" -I COMMAND bash -c 'COMMAND')
}

if build release all -DCMAKE_EXPORT_COMPILE_COMMANDS=ON; then
	run_tests release
	if command -v clang++-14 >/dev/null; then
		check "Compiling with clang" compile_with_clang
	else
		skipped+=("clang: no clang++-14")
	fi
else
	failed=$((failed + 1))
fi
if build asan cpu_tests; then
	run_tests asan -L '^cpu$'
else
	failed=$((failed + 1))
fi
# VTK is not built for the thread sanitizer: what links it, or talks to it, stays out.
if build tsan unit_tests; then
	# Neither is TBB: the sanitizer cannot see that the end of a loop waits for its bodies. On one core TBB starts no
	# threads of its own, while those of the program and its tests run as ever.
	core=$(taskset -cp $$ | sed 's/.*: *\([0-9]*\).*/\1/')
	launcher=(taskset -c "$core")
	TSAN_OPTIONS="suppressions=$PWD/tests/tsan.supp" run_tests tsan -R '^unit_'
else
	failed=$((failed + 1))
fi
if [[ -n $long ]] && command -v clang++-14 >/dev/null; then
	if build fuzz fuzz_parsers_guided; then
		run_tests fuzz -R '^fuzz\.parser'
	else
		failed=$((failed + 1))
	fi
fi
if command -v clang-format-14 >/dev/null; then
	check "Format" check_format
else
	skipped+=("format: no clang-format-14")
fi

printf 'skipped: %s\n' "${skipped[@]}" | sed '/^skipped: $/d'
printf '%s\n' "${skipped[@]}" >build/skipped.txt
echo "$passed passed, $failed failed, ${#skipped[@]} skipped"
((failed == 0))
