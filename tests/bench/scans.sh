#!/usr/bin/env bash
# The faults of meshes of thinned, moved, roughened and doubled points (scan_variants.py), by the
# rules `paper` and `robust`, k = 12. Prints a Markdown table with a row for each variant of each
# file, then one with a row for each variant. Files without normals get those that `run` derives.
#   tests/bench/scans.sh PROGRAM FILE...     PROGRAM: build/bin/spiraling-edge
# A run that crashes, or takes longer than LIMIT seconds (120), is a row as well; its input, and
# that of a run by `robust` that is not manifold, is copied to the folder KEEP, if that is set.
set -uo pipefail
[ $# -ge 2 ] || { echo "usage: $0 PROGRAM FILE..." >&2; exit 2; }
here=$(cd "$(dirname "$0")" && pwd)
program=$1
shift
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
variants=(given half quarter moved "rough 0.1" "rough 0.2" "rough 0.4" doubled)

# measure FILE RULES: points, faults, their classes, and seconds, between tabs.
measure() {
    local code=0
    rm -f "$work/report.json"
    timeout "${LIMIT:-120}" "$program" run "$1" --rules "$2" -k 12 --check --report "$work/report.json" -q \
        2>"$work/err" || code=$?
    if [ $code -gt 1 ] || [ ! -s "$work/report.json" ]; then
        [ $code = 124 ] && echo "no end in ${LIMIT:-120} s" >"$work/err"
        printf -- '-\t-\tcode %s: %s\t-\n' $code "$(head -c 200 "$work/err" | tr '\n\t|' '   ')"
    else
        awk '
            function value() { sub(/^[^:]*: */, ""); sub(/,$/, ""); return $0 }
            /^  "stop_reason": "capped"/ { classes = "capped" }
            /^  "points":/ { points = value() }
            /^  "triangles": 0,/ { classes = "no triangle" }
            /^    "(prepare|triangulate)":/ { seconds += value() }
            /^    "exact": false/ { more = "at least " }
            /^  "faults": \{/ { inside = 1; next }
            inside && /\}/ { inside = 0 }
            inside {
                name = $1
                gsub(/[":]/, "", name)
                count = value() + 0
                faults += count
                if (count > 0) classes = classes (classes == "" ? "" : ", ") count " " name
            }
            END { printf "%d\t%d\t%s\t%.2f\n", points, faults, classes == "" ? "sound" : more classes, seconds }' "$work/report.json"
    fi
}

# keep FILE NAME CLASSES: keeps the input of a run that went badly wrong.
keep() {
    [ -n "${KEEP:-}" ] && grep -qE 'code|non_manifold|capped|inconsistent' <<<"$3" || return 0
    mkdir -p "$KEEP"
    cp "$1" "$KEEP/$2.${1##*.}"
}

echo "| file | variant | points | paper | robust | left by robust | seconds |"
echo "|---|---|--:|--:|--:|---|--:|"
for file in "$@"; do
    rm -f "$work"/*.off
    name=$(basename "$file")
    "$program" run "$file" --max-pivots 0 -q --normals -o "$work/base.off" 2>"$work/err" ||
        { echo "| $name | | | | | $(head -1 "$work/err") | |"; continue; }
    spacing=$("$program" info "$work/base.off" --json | sed -nE 's/^    "mean": (.*),$/\1/p')
    "$here/scan_variants.py" "$work/base.off" "${spacing:-0}" "$work" || continue
    for variant in "${variants[@]}"; do
        input=$work/$variant.off
        [ "$variant" != given ] || input=$file
        IFS=$'\t' read -r _ paper _ _ < <(measure "$input" paper)
        IFS=$'\t' read -r points robust classes seconds < <(measure "$input" robust)
        keep "$input" "${name%.*} $variant" "$classes"
        echo "| ${name%.*} | $variant | $points | $paper | $robust | $classes | $seconds |"
    done
done | tee "$work/rows"

# A row of - is a run without a result: it counts as a file, and in nothing else.
echo
echo "| variant | files | points | paper | sound | robust | sound | faults per 1,000 points |"
echo "|---|--:|--:|--:|--:|--:|--:|--:|"
for variant in "${variants[@]}"; do
    awk -F ' *\\| *' -v variant="$variant" '
        $3 == variant {
            files++
            if ($5 == "-" || $6 == "-") next
            points += $4
            paper += $5
            robust += $6
            papers += $5 == 0
            robusts += $6 == 0
        }
        END {
            rate = points > 0 ? 1000 * robust / points : 0
            printf "| %s | %d | %d | %d | %d | %d | %d | %.2f |\n", variant, files, points, paper, papers, robust,
                robusts, rate
        }' "$work/rows"
done
