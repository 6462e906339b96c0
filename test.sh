#!/usr/bin/env bash
# Installs what is missing, builds everything with warnings as errors and runs every check:
#   asan      core and its tests with address and undefined behavior sanitizers
#   lean      optimized programs, tested from outside; the viewer also under a virtual display
#   the rest  layers, format, clang-tidy, use as a library by another project
#   ./test.sh [-j N]
# Everything goes to build-test/; logs to build-test/logs/. The last line counts.
set -uo pipefail
cd "$(dirname "$0")" || exit 1
jobs=$(nproc)
while getopts j: option; do
    case $option in
        j) jobs=$OPTARG ;;
        *) exit 2 ;;
    esac
done
logs=build-test/logs
mkdir -p "$logs"
passed=0
failed=0
summary=()
began=$SECONDS

# step NAME COMMAND...: one check; its output is shown if it fails.
step() {
    local name=$1 start=$SECONDS
    shift
    if "$@" >"$logs/$name.log" 2>&1 </dev/null; then
        passed=$((passed + 1))
        summary+=("$(printf 'ok    %-22s %4d s' "$name" $((SECONDS - start)))")
    else
        failed=$((failed + 1))
        summary+=("$(printf 'FAIL  %-22s %4d s   %s' "$name" $((SECONDS - start)) "$logs/$name.log")")
        echo "---- $name failed; the end of $logs/$name.log:"
        tail -n 60 "$logs/$name.log"
        echo "----"
    fi
    echo "${summary[-1]}"
}

# suite NAME BUILD ARGUMENTS...: ctest; every test counts by itself.
suite() {
    local name=$1 build=$2 start=$SECONDS log=$logs/$1.log line bad all
    shift 2
    ctest --test-dir "$build" --output-on-failure --no-tests=error -j "$jobs" "$@" >"$log" 2>&1 </dev/null
    line=$(grep -E '[0-9]+% tests passed' "$log" | tail -1)
    if [ -z "$line" ]; then
        failed=$((failed + 1))
        summary+=("$(printf 'FAIL  %-22s %4d s   %s' "$name" $((SECONDS - start)) "$log")")
        tail -n 20 "$log"
        return
    fi
    bad=$(sed -E 's/.*passed, ([0-9]+) tests? failed.*/\1/' <<<"$line")
    all=$(sed -E 's/.* out of ([0-9]+).*/\1/' <<<"$line")
    passed=$((passed + all - bad))
    failed=$((failed + bad))
    [ "$bad" = 0 ] || grep -vE '^ *[0-9]+/[0-9]+ Test .* Passed|^ *Start ' "$log" | head -n 200
    sed -n '/% tests passed/,$p' "$log"
    summary+=("$(printf '%-5s %-22s %4d s   %s of %s' "$([ "$bad" = 0 ] && echo ok || echo FAIL)" \
        "$name" $((SECONDS - start)) $((all - bad)) "$all")")
    echo "${summary[-1]}"
}

configure_asan() { cmake --preset asan -B build-test/asan; }
# Core's own tests run in the other build; tests/cli compares golden logs of the two.
lean_targets=(spiraling-edge spiraling-edge-viewer viewer_tests core_bench)
lean_flags=(-DSPIRALING_EDGE_WERROR=ON "-DCMAKE_CXX_FLAGS_RELEASE=-O2")
configure_lean() {
    cmake --preset release -B build-test/lean -DSPIRALING_EDGE_BUILD_TESTS=ON \
        -DSPIRALING_EDGE_BUILD_BENCH=ON "${lean_flags[@]}"
}
check_format() {
    find core app tests -name '*.cpp' -o -name '*.h' | sort |
        xargs "$(command -v clang-format-14 || command -v clang-format)" --dry-run -Werror
}
consumer() {
    # The same flags as in the build before, so that ccache knows the library's files.
    local flags=("${lean_flags[@]}")
    command -v ccache >/dev/null && flags+=(-DCMAKE_CXX_COMPILER_LAUNCHER=ccache)
    tests/consumer/run.sh build-test/lean "${flags[@]}"
}

export CMAKE_BUILD_PARALLEL_LEVEL=$jobs
step packages .ci/packages.sh test
step layers .ci/layers.sh
step format check_format
step asan_configure configure_asan
step asan_build cmake --build build-test/asan
export ASAN_OPTIONS=detect_leaks=1:strict_string_checks=1 UBSAN_OPTIONS=halt_on_error=1:print_stacktrace=1
[ ! -f build-test/asan/CTestTestfile.cmake ] || suite asan_tests build-test/asan
step lean_configure configure_lean
step lean_build cmake --build build-test/lean --target "${lean_targets[@]}"
[ ! -f build-test/lean/CTestTestfile.cmake ] || suite lean_tests build-test/lean \
    --label-exclude 'core|fuzz' --exclude-regex NOT_BUILT
step bench build-test/lean/bin/core_bench --benchmark_min_time=0.01
step consumer consumer
step tidy .ci/tidy.sh build-test/lean

echo
printf '%s\n' "${summary[@]}"
echo "$((SECONDS - began)) s in all"
echo
echo "$passed passed, $failed failed"
[ "$failed" = 0 ]
