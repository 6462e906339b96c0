#!/usr/bin/env bash
# Installs missing packages, builds everything with warnings as errors and runs every check:
#   asan      core and its tests, but for the long ones, with address and undefined behavior sanitizers
#   lean      optimized programs, tested from outside; the viewer also under a virtual display; core's long tests
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
rm -f "$logs"/*.status
passed=0
failed=0
summary=()
began=$SECONDS

# run NAME COMMAND...: one check, its output in a log, its exit status and seconds beside that.
run() {
    local name=$1 start=$SECONDS
    shift
    "$@" >"$logs/$name.log" 2>&1 </dev/null
    echo "$? $((SECONDS - start))" >"$logs/$name.status"
}

# judge NAME: one line about a check that has run. Each test of a suite counts separately.
judge() {
    local name=$1 log=$logs/$1.log status seconds tests bad all=1 ending=
    read -r status seconds <"$logs/$name.status"
    bad=$((status != 0))
    tests=$(grep -E '[0-9]+% tests passed' "$log" | tail -1)
    if [ -n "$tests" ]; then
        bad=$(sed -E 's/.*passed, ([0-9]+) tests? failed.*/\1/' <<<"$tests")
        all=$(sed -E 's/.* out of ([0-9]+).*/\1/' <<<"$tests")
        # A test of ctest runs all cases of a file where starting a program takes long.
        all=$((all + $(awk '/^cases beside:/ { print $3 }' "$log")))
        [ "$bad" != 0 ] || bad=$((status != 0))
        ending="   $((all - bad)) of $all"
    fi
    passed=$((passed + all - bad))
    failed=$((failed + bad))
    if [ "$bad" != 0 ]; then
        ending+="   $log"
        echo "---- $name failed:"
        grep -vE '^ *[0-9]+/[0-9]+ Test .* Passed|^ *Start ' "$log" | tail -n 120
        echo "----"
    fi
    summary+=("$(printf '%-5s %-16s %4d s%s' "$([ "$bad" = 0 ] && echo ok || echo FAIL)" \
        "$name" "$seconds" "$ending")")
    echo "${summary[-1]}"
}
step() { run "$@"; judge "$1"; }

configure_asan() { cmake --preset asan -B build-test/asan; }
# Core's own tests run in the other build, but for the long ones; tests/cli compares golden logs of the two.
lean_targets=(spiraling-edge spiraling-edge-viewer viewer_tests teach_tests long_tests core_bench viewer_bench driven-viewer agreement
    spiraling_edge_python)
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
    # Compiled fast, since it runs once; the results must not depend on the build type anyway, nor
    # on threads, which this build is without.
    tests/consumer/run.sh build-test/lean -DSPIRALING_EDGE_THREADS=OFF -DSPIRALING_EDGE_WERROR=ON -DCMAKE_CXX_FLAGS_RELEASE=-O0 \
        -DCMAKE_UNITY_BUILD=ON -DCMAKE_UNITY_BUILD_BATCH_SIZE=48
}

# tests_of BUILD ARGUMENTS...: ctest
tests_of() {
    [ -f "$1/CTestTestfile.cmake" ] || { echo "not built"; return 1; }
    local status=0
    ctest --test-dir "$1" --output-on-failure --no-tests=error -j "$jobs" "${@:2}" || status=$?
    awk '/^\[doctest\] test cases:/ { beside += $4 - 1 } END { print "cases beside:", beside + 0 }' \
        "$1/Testing/Temporary/LastTest.log"
    return "$status"
}
lean_tests() { tests_of build-test/lean --label-exclude 'core|fuzz' --exclude-regex NOT_BUILT; }
# Checks that only compute, in the time that the window's tests leave: those depend on a clock.
meanwhile() {
    chrt --idle -p 0 "$BASHPID" 2>/dev/null || renice -n 19 "$BASHPID" >/dev/null
    run bench build-test/lean/bin/core_bench --benchmark_min_time=0.01
    run consumer consumer
    run long_tests build-test/lean/tests/long_tests --test-suite=long
    run asan_tests tests_of build-test/asan
    run tidy .ci/tidy.sh build-test/lean
}

export CMAKE_BUILD_PARALLEL_LEVEL=$jobs
# Short stacks of allocations and few freed blocks kept: core's tests take a fifth less time.
export ASAN_OPTIONS=detect_leaks=1:strict_string_checks=1:malloc_context_size=5:quarantine_size_mb=16
export UBSAN_OPTIONS=halt_on_error=1:print_stacktrace=1
step packages .ci/packages.sh test
step layers .ci/layers.sh
step format check_format
step asan_configure configure_asan
step asan_build cmake --build build-test/asan
step lean_configure configure_lean
step lean_build cmake --build build-test/lean --target "${lean_targets[@]}"
meanwhile &
step lean_tests lean_tests
wait
for name in bench consumer long_tests asan_tests tidy; do judge "$name"; done

echo
printf '%s\n' "${summary[@]}"
echo "$((SECONDS - began)) s in all"
echo
echo "$passed passed, $failed failed"
[ "$failed" = 0 ]
