#!/usr/bin/env bash
# Counts the faults of meshes by a checker that shares no code with the program, and compares them
# with the program's own.
#   soundness.sh PROGRAM CHECKER [FILE...]    default: scenes that are sound, and one that is not
# With files: one line for each, by the rules `robust`.
set -euo pipefail
program=$1
checker=$2
shift 2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# counts INPUT RULES: the checker's line, without the name.
counts() {
    "$program" run "$1" --rules "$2" -q --normals -o "$work/mesh.off" --report "$work/report.json"
    "$checker" "$work/mesh.off" | sed 's/^[^:]*: //' || true
}
# reported NAME: a number of the report; found NAME LINE: of the checker.
reported() { grep -oE "\"$1\": [0-9]+" "$work/report.json" | head -1 | grep -oE '[0-9]+$'; }
found() { grep -oE "(^| )$1 [0-9]+" <<<"$2" | grep -oE '[0-9]+$'; }

if [ $# -gt 0 ]; then
    for file in "$@"; do echo "$(basename "$file"): $(counts "$file" robust)"; done
    exit 0
fi
bad=0
for input in sphere torus linked-tori genus-2 four-edge-hole noise half-turn finished-edge; do
    for rules in paper robust; do
        line=$(counts "scene:$input" "$rules")
        while read -r ours theirs; do
            if [ "$(reported "$ours")" != "$(found "$theirs" "$line")" ]; then
                echo "scene:$input --rules $rules: $ours is $(reported "$ours"), but: $line"
                bad=1
            fi
        done <<'NAMES'
flipped flipped
intersecting intersecting
folded folded
second_layers second_layers
degenerate needles
non_manifold_edge non_manifold_edges
non_manifold_vertices non_manifold_vertices
inconsistent_edges inconsistent_edges
unused_points unused
components components
NAMES
    done
done
exit $bad
