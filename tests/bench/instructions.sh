#!/usr/bin/env bash
# Instructions of the triangulation alone, neighbors given, on the main thread, by the rules `paper`
# and `robust`, and their ratio, as a Markdown table. Unlike seconds these hardly depend on other
# work of the machine. Needs valgrind.
#   tests/bench/instructions.sh PROGRAM FILE...     PROGRAM: build/bin/spiraling-edge
set -euo pipefail
[ $# -ge 2 ] || { echo "usage: $0 PROGRAM FILE..." >&2; exit 2; }
program=$1
shift
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# millions FILE RULES: of instructions in se::reconstruct().
millions() {
    valgrind --tool=callgrind --callgrind-out-file="$work/out" --toggle-collect='se::reconstruct(*' \
        "$program" run "$1" --rules "$2" -q 2>"$work/log" || { cat "$work/log" >&2; exit 1; }
    awk '/^(summary|totals):/ { printf "%.1f", $2 / 1e6; exit }' "$work/out"
}

echo "| set | paper, millions | robust, millions | ratio |"
echo "|---|--:|--:|--:|"
for file in "$@"; do
    paper=$(millions "$file" paper)
    robust=$(millions "$file" robust)
    echo "| $(basename "${file%.*}") | $paper | $robust | $(awk "BEGIN { printf \"%.1f\", $robust / $paper }") |"
done
