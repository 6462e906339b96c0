#!/usr/bin/env bash
# Counts the faults of meshes by a checker that shares no code with the program, and compares them
# with the program's own, by the rules `paper` and `robust`. Fails if any number differs.
#   soundness.sh PROGRAM CHECKER [FILE...]    default: scenes; for files it prints all numbers
set -euo pipefail
program=$1
checker=$2
shift 2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# counts INPUT RULES: the checker's line, without the name.
counts() {
    "$program" run "$1" --rules "$2" -q -o "$work/mesh.ply" --report "$work/report.json"
    "$checker" "$work/mesh.ply" | sed 's/^[^:]*: //' || true
}
# reported NAME: a number of the report, PART.NAME for one of a part of it.
reported() {
    awk -F '[ ":,]+' -v wanted="$1" '
        /^  \}/ { part = "" }
        part $2 == wanted && $3 ~ /^[0-9]+$/ { print $3; exit }
        /^  "[a-z_]+": \{$/ { part = $2 "." }' "$work/report.json"
}
# counted NAME: as reported, or, where the report judges by other normals than those of the mesh, as `check` counts the
# mesh alone, for classes that go by normals.
counted() {
    if grep -q '"judged": "' "$work/report.json" && [[ $1 == faults.@(flipped_triangles|second_layers) ]]; then
        "$program" check "$work/mesh.ply" --json >"$work/check.json" || true
        grep -oE "\"${1#faults.}\": [0-9]+" "$work/check.json" | grep -oE '[0-9]+$'
    else
        reported "$1"
    fi
}
# found NAME LINE: a number of the checker.
found() { grep -oE "(^| )$1 [0-9]+" <<<"$2" | grep -oE '[0-9]+$'; }

inputs=("$@")
[ $# -gt 0 ] || inputs=(scene:{sphere,torus,linked-tori,genus-2,sheet,grid,long-lists,figure-14,half-turn,finished-edge} \
    scene:{four-edge-hole,noise,tee-at-wall,close-sheets,uneven-density,flipped-patch,near-duplicates,stranded-point})
bad=0
for input in "${inputs[@]}"; do
    for rules in paper robust; do
        line=$(counts "$input" "$rules")
        [ $# = 0 ] || echo "$(basename "$input"), $rules: $line"
        while read -r ours theirs; do
            # Their triangles touch and overlap in planes: see soundness_check.cpp.
            # Which loops are openings of the points only the program knows.
            [[ $ours != verdict.@(hole_edges|points_not_covered) || $line == *" openings 0 "* ]] || continue
            [[ $ours != faults.intersecting_triangles || $input != scene:@(tee-at-wall|close-sheets) ]] || continue
            if [ "$(counted "$ours")" != "$(found "$theirs" "$line")" ]; then
                echo "$input --rules $rules: $ours is $(counted "$ours"), but: $line"
                bad=1
            fi
        done <<'NAMES'
faults.non_manifold_edges non_manifold_edges
faults.non_manifold_vertices non_manifold_vertices
faults.inconsistent_edges inconsistent_edges
faults.degenerate_triangles needles
faults.intersecting_triangles intersecting
faults.folded_edges folded
faults.second_layers second_layers
faults.flipped_triangles flipped
faults.holes holes
faults.small_components small_components
boundary_loops loops
verdict.hole_edges hole_edges
verdict.pieces_facing_in inward
verdict.points_lost lost
verdict.points_not_covered uncovered
verdict.pieces_of_points pieces
verdict.twin_points twins
components components
points_in_no_triangle unused
NAMES
    done
done
exit $bad
