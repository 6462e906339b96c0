#!/usr/bin/env bash
# The effect of each rule beyond the paper: `--rules robust` with one rule off at a time, over a
# list of point files. Prints a Markdown table: files with a sound mesh, faults, lost points,
# boundary loops and seconds in all. With --without RULE that rule is off in every row: one rule may
# hide what another is worth.
#   tests/bench/ablate.sh PROGRAM [--without RULE] FILE...     PROGRAM: build/bin/spiraling-edge
set -uo pipefail
[ $# -ge 2 ] || { echo "usage: $0 PROGRAM [--without RULE] FILE..." >&2; exit 2; }
program=$1
shift
always=()
if [ "$1" = --without ]; then
    always=(--rule "$2=off")
    shift 2
fi

# One line per file: sound faults unused loops seconds.
measure() {
    local file
    for file in "$@"; do
        "$program" run "$file" --rules robust "${always[@]}" "${off[@]}" --report - -q 2>/dev/null
    done | awk '
        function value() { sub(/^[^:]*: */, ""); sub(/,$/, ""); return $0 }
        /^    "sound":/ { if (value() == "true") sound++ }
        /^  "points_in_no_triangle":/ { unused += value() }
        /^  "boundary_loops":/ { loops += value() }
        /^    "triangulate":/ { seconds += value() }
        /^  "faults": \{/ { inside = 1; next }
        inside && /\}/ { inside = 0 }
        inside { faults += value() }
        END { printf "%d | %d | %d | %d | %.2f\n", sound, faults, unused, loops, seconds }'
}

echo "| off | sound of $# | faults | lost points | boundary loops | seconds |"
echo "|---|---|---|---|---|---|"
off=()
echo "| nothing | $(measure "$@") |"
for rule in tangent unblocked stepback wallsdone bothwalls guard gap nopillow nocross nofold nomeet nolayer rim delay \
    shelve fill droppatches reinsert closeholes flip remesh; do
    off=(--rule "$rule=off")
    echo "| \`$rule\` | $(measure "$@") |"
done
