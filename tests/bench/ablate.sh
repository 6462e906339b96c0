#!/usr/bin/env bash
# The effect of each rule beyond the paper: `--rules robust` with one rule off at a time, over a
# list of point files. Prints a Markdown table: files with a sound mesh, faults, lost points,
# boundary loops and seconds in all. With --pairs the table has a row for each two rules that are
# off together: one rule may hide what another is worth.
#   tests/bench/ablate.sh PROGRAM [--pairs] FILE...     PROGRAM: build/bin/spiraling-edge
set -uo pipefail
[ $# -ge 2 ] || { echo "usage: $0 PROGRAM [--pairs] FILE..." >&2; exit 2; }
program=$1
shift
pairs=
if [ "$1" = --pairs ]; then
    pairs=1
    shift
fi
rules=(tangent unblocked stepback wallsdone bothwalls guard gap nopillow nocross nofold nomeet nolayer rim delay shelve
    fill droppatches reinsert closeholes flip remesh)

# One line for all files: sound faults lost loops seconds.
measure() {
    local file
    for file in "${files[@]}"; do
        "$program" run "$file" --rules robust "$@" --report - -q 2>/dev/null
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

files=("$@")
echo "| off | sound of $# | faults | lost points | boundary loops | seconds |"
echo "|---|---|---|---|---|---|"
echo "| nothing | $(measure) |"
for rule in "${rules[@]}"; do
    if [ -z "$pairs" ]; then
        echo "| \`$rule\` | $(measure --rule "$rule=off") |"
        continue
    fi
    for other in "${rules[@]}"; do
        [[ "$rule" < "$other" ]] || continue
        echo "| \`$rule\`, \`$other\` | $(measure --rule "$rule=off" --rule "$other=off") |"
    done
done
