#!/usr/bin/env bash
# The cost of each missing input: the table of docs/performance.md, "Missing inputs".
#   tests/bench/costs.sh PROGRAM FILE...
# FILE needs normals; they are derived again and compared with those of the file.
set -euo pipefail
export LC_ALL=C
program=$1
shift
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# run NAME FILE OPTION...: leaves the report in NAME.
run() {
    local name=$1 file=$2
    shift 2
    "$program" run "$file" --rules robust -q --report "$work/$name" "$@"
}
# value NAME KEY: the first number or word of that name in the report.
value() {
    sed -nE "s/^ *\"$2\": ([^,]*),?\$/\1/p" "$work/$1" | head -n 1
}
# faults NAME: of all classes together.
faults() {
    awk '/"faults": \{/ { inside = 1; next } inside && /\}/ { exit }
         inside { gsub(/[^0-9]/, ""); sum += $0 } END { print sum + 0 }' "$work/$1"
}
# seconds NAME PIECE: of a derived piece.
seconds() {
    awk -v piece="\"$2\":" '/"derived": \{/ { inside = 1 } inside && /"seconds"/ { deep = 1 }
         deep && $1 == piece { gsub(/,/, "", $2); printf "%.3f", $2; exit }' "$work/$1"
}

echo "| set | points | neighbors s | normals s | sides s | rims s | triangulation s | triangles, given / derived | faults, given / derived | loops, given / derived |"
echo "|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|"
for file in "$@"; do
    run given "$file" -k 12
    run derived "$file" -k 12 --derive-normals
    run rims "$file" -k 12 --derive-rim
    printf '| %s | %s | %s | %s | %s | %s | %.3f | %s / %s | %s / %s | %s / %s |\n' "$(basename "${file%.*}")" \
        "$(value given points)" "$(seconds derived neighbors)" "$(seconds derived normals)" \
        "$(seconds derived orientation)" "$(seconds rims rim)" "$(value given triangulate)" \
        "$(value given triangles)" "$(value derived triangles)" "$(faults given)" "$(faults derived)" \
        "$(value given boundary_loops)" "$(value derived boundary_loops)"
done
