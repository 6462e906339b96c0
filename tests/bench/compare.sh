#!/usr/bin/env bash
# Our program compared with other methods on the same points: a Markdown table per input, and the
# growth of the times with the number of points. See docs/performance.md.
#   tests/bench/compare.sh [-n REPEATS] [-o FOLDER] [-m "METHODS"] [-g "SIZES"] [-b BUILD] [INPUT...]
#     -n repeats (3); the table has medians. The programs take turns, so that load falls on all -o
#     where results go (out/compare): runs.csv, table.md, growth.csv, growth.svg -m peers (gp3
#     gp3:12 afs bpa alpha crust hoppe poisson), :K for that many neighbors; "" for none -g sizes of
#     the growing sphere ("1000 10000 100000 1000000"); "" for none -b build folder (build-peers);
#     configured and built if the programs are missing
#   INPUT: point files with normals. Default: a sphere and a torus of 43,000 points.
#   GROWTH_PEERS ("gp3 afs bpa"): the peers of the growing sphere, up to a million points.
#   LIMIT (900): seconds for one run.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
root=$(cd "$here/../.." && pwd)
repeats=3
out=$root/out/compare
peers="gp3 gp3:12 afs bpa alpha crust hoppe poisson"
sizes="1000 10000 100000 1000000"
build=$root/build-peers
while getopts n:o:m:g:b: option; do
    case $option in
        n) repeats=$OPTARG ;;
        o) out=$OPTARG ;;
        m) peers=$OPTARG ;;
        g) sizes=$OPTARG ;;
        b) build=$OPTARG ;;
        *) exit 2 ;;
    esac
done
shift $((OPTIND - 1))
growth_peers=${GROWTH_PEERS-gp3 afs bpa}
limit=${LIMIT:-900}
own="paper robust" # sets of rules of our own program

if [ ! -x "$build/bin/spiraling-edge-peer" ] || [ ! -x "$build/bin/spiraling-edge" ]; then
    cmake --preset release -S "$root" -B "$build" -DSPIRALING_EDGE_BUILD_PEERS=ON \
        -DSPIRALING_EDGE_BUILD_VIEWER=OFF >&2
    cmake --build "$build" --target spiraling-edge spiraling-edge-peer spiraling-edge-peer-tool >&2
fi
tool=$build/bin/spiraling-edge-peer-tool
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
mkdir -p "$out"

# field FILE NAME: a number in our JSON, where every member has its line.
field() { sed -nE "s/^ *\"$2\": ([-+.0-9eE]+),?$/\1/p" "$1" | head -n 1; }

# run METHOD INPUT: one run; prints read,neighbors,reconstruct,write,cpu,triangles or fails. The mesh
# is left in $scratch/METHOD.ply.
run() {
    local method=$1 input=$2 json=$scratch/$1.json search=neighbors reconstruct=reconstruct cpu
    local TIMEFORMAT='%U %S' more=()
    [[ $method != *:* ]] || more=(--neighbors "${method#*:}")
    if [[ " $own " == *" $method "* ]]; then
        search=prepare reconstruct=triangulate
        { time timeout "$limit" "$build/bin/spiraling-edge" run "$input" --rules "$method" --report "$json" \
            -o "$scratch/$method.ply" -q >/dev/null 2>&3; } 3>"$scratch/$method.log" 2>"$scratch/cpu" || return 1
    else
        { time timeout "$limit" "$build/bin/spiraling-edge-peer" "${method%%:*}" "$input" \
            --json ${more[@]+"${more[@]}"} -o "$scratch/$method.ply" >"$json" 2>&3; } 3>"$scratch/$method.log" 2>"$scratch/cpu" || return 1
    fi
    cpu=$(awk '{ print $1 + $2 }' "$scratch/cpu")
    echo "$(field "$json" read),$(field "$json" $search),$(field "$json" $reconstruct),$(field "$json" write),$cpu,$(field "$json" triangles)"
}

# measure CSV LABEL INPUT REPEATS METHODS...: lines "label,method,repeat,...", in turns. A method
# that failed or took too long is not run again.
measure() {
    local csv=$1 label=$2 input=$3 repeats=$4 repeat method line
    local -A failed=()
    shift 4
    for repeat in $(seq "$repeats"); do
        for method in "$@"; do
            [ -z "${failed[$method]:-}" ] || continue
            if line=$(run "$method" "$input"); then
                echo "$label,$method,$repeat,$line" | tee -a "$csv" >&2
            else
                failed[$method]=yes
                echo "$label: $method failed or took over $limit s: $(tail -n 1 "$scratch/$method.log" 2>/dev/null)" >&2
            fi
        done
    done
}

# soundness METHOD: the cells of the table that count the faults of its mesh.
soundness() {
    local json=$scratch/check.json flipped
    timeout "$limit" "$tool" check "$scratch/$1.ply" >"$json" || { echo " ? | ? | ? | ? | ?"; return; }
    flipped=$(field "$json" flipped_triangles)
    # These two do not orient triangles; we turn each by its normals.
    case $1 in alpha | crust) flipped= ;; esac
    echo " $(field "$json" lost_points) | $(field "$json" non_manifold_edges) | $(field "$json" boundary_loops) | ${flipped:-n/a} | $(field "$json" intersecting_triangles)"
}

# table LABEL INPUT: medians and faults of all methods on one input.
table() {
    local label=$1 input=$2 method
    # shellcheck disable=SC2086  # lists of words
    measure "$out/runs.csv" "$label" "$input" "$repeats" $own $peers
    echo
    echo "$label, $("$tool" check "$input" | sed -nE 's/.*"points": ([0-9]+).*/\1/p' | head -n 1) points, medians of $repeats:"
    echo
    echo "| method | read s | neighbors s | reconstruct s | write s | CPU s | reconstruct, ratio | in all, ratio | triangles | lost points | non-manifold edges | boundary loops | flipped | intersecting |"
    echo "|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|"
    for method in $own $peers; do
        awk -F, -v label="$label" -v method="$method" -v base="${own%% *}" -f "$here/compare_row.awk" "$out/runs.csv" |
            while read -r row; do echo "$row$(soundness "$method") |"; done
    done
}

# growth: one line per size and method; large sizes run once.
growth() {
    local size
    echo "points,method,repeat,read,neighbors,reconstruct,write,cpu,triangles" >"$out/growth.csv"
    for size in $sizes; do
        "$tool" shape sphere "$size" "$scratch/sphere.ply"
        # shellcheck disable=SC2046,SC2086
        measure "$out/growth.csv" "$size" "$scratch/sphere.ply" $((size > 500000 ? 1 : repeats)) \
            $own $([ "$size" -gt 1000000 ] || echo "$growth_peers")
    done
    awk -F, -f "$here/growth_plot.awk" "$out/growth.csv" >"$out/growth.svg"
}

if [ $# -eq 0 ]; then
    for shape in sphere torus; do
        "$tool" shape $shape 43000 "$scratch/$shape.ply"
        set -- "$@" "$scratch/$shape.ply"
    done
fi
echo "input,method,repeat,read,neighbors,reconstruct,write,cpu,triangles" >"$out/runs.csv"
{
    echo "Measured on: $(sed -nE 's/^model name[^:]*: //p' /proc/cpuinfo | head -n 1), $(nproc) cores, load $(cut -d' ' -f1 /proc/loadavg)"
    for input in "$@"; do table "$(basename "$input" .ply)" "$input"; done
} | tee "$out/table.md"
[ -z "$sizes" ] || growth
