#!/usr/bin/env bash
# Makes the pictures of README.md and the pages here. Needs no display, but ImageMagick's convert.
#   docs/make-pictures.sh [VIEWER]          all of them
#   docs/make-pictures.sh VIEWER stages     those of every stage (docs/viewer.md) alone
#   docs/make-pictures.sh VIEWER new        that of the page with new points alone
#   docs/make-pictures.sh VIEWER table1 DIR  the paper's Figures 21 to 25 (docs/table1.md); DIR has the volumes
set -euo pipefail
cd "$(dirname "$0")"
viewer=${1:-../build/bin/spiraling-edge-viewer}
mkdir -p images

# NAME SCENE ADDRESS [OPTION...]: what the view shows of one decision, in few colors.
stage() {
    local name=$1 scene=$2 address=$3
    shift 3
    "$viewer" "scene:$scene" --no-config --layout present --ui-scale 0.9 --size 900x560 \
        --goto "$address" "$@" --screenshot "images/stage-$name.png"
    convert "images/stage-$name.png" +dither -colors 144 -strip -define png:compression-level=9 \
        "PNG8:images/stage-$name.png"
}

# NAME SCENE ADDRESS X,Y,Z DISTANCE YAW PITCH [OPTION...]: the same as seen from there.
stage_from() {
    local name=$1 scene=$2 address=$3 target=$4 distance=$5 yaw=$6 pitch=$7
    shift 7
    stage "$name" "$scene" "$address" --place "{\"address\": \"$address\", \"camera\": {
        \"target\": [$target], \"distance\": $distance, \"yaw\": $yaw, \"pitch\": $pitch}}" "$@"
}

stages() {
    stage_from seed linked-tori 537.seed.1 -0.2,0.22,0.14 1.6 -152 27
    stage strand sphere 425.strand.1 --focus
    stage skip figure-14 15.skip.1 --focus
    stage insert figure-14 1.insert.1 --focus
    stage insert-corner figure-14 31.insert.1 --focus
    stage sort torus 333.sort.9 --focus
    stage sort-beyond sphere 100.sort.8 --focus
    stage sort-tie grid 4.sort.13 --focus
    stage limits figure-8 8.limits.3 --focus
    stage_from convex small-torus 54.convex.1 -0.42,0.13,0.07 1.2 35 20
    stage reciprocal coarse-torus 42.reciprocal.1 --focus
    stage_from hole linked-tori 120.hole.2 0.668,0.207,0.40 0.5 62 25 --neighbors 24
    stage sphere-inside sphere 30.sphere.1 --focus
    stage sphere-removed sphere 30.sphere.2 --focus
    stage sphere-gap small-torus 29.sphere.4 --focus
    stage twopoint coarse-torus 15.twopoint.1 --focus
    stage twopoint-over coarse-torus 87.twopoint.1 --focus
    stage emit sphere 30.emit.2 --focus
    stage ring sphere 14.ring.4 --focus
    stage split figure-12 35.split.1 --focus
    stage split-second figure-12 35.split.2 --focus
    stage join figure-12 74.join.1 --focus
    stage advance sphere 14.advance.1 --focus
    stage done linked-tori 536.done.1
    stage done-alert genus-2 630.done.7 --neighbors 24 --focus
    stage done-rim sheet 777.done.64
    # Rules beyond the paper.
    stage guard small-torus 52.guard.1 --rules robust --focus
    stage fill linked-tori 600.fill.1 --focus --neighbors 24 --rule fill=on
    stage_from reinsert long-lists 143.reinsert.1 0.30,0.68,0.26 1.15 25 35 --neighbors 16 --rules robust
    stage_from flip torus 887.flip.1 0.297,-0.952,0.038 0.6 -72.7 7.7 --rules robust
    stage reseat linked-tori 1598.reseat.1 --focus --neighbors 32 --rules corrected \
        --rule guard=on --rule reinsert=on --rule flip=on --rule reseat=on
}

# What belongs to a decision and not to the surface.
kept_out='"points": "off", "ring": "off", "stack": "off", "sector": "off", "neighbors": "off", "walls": "off",
    "mending": "off", "labels": "off", "selection": "off", "marked": "off"'

# FIGURE SET X,Y,Z DISTANCE YAW PITCH [OPTION...]: a set of Table 1, triangulated, as seen from there. Drawn twice
# as large as it is shown; of the window nothing but the view.
figure() {
    local picture="images/figure-$1.png" set=$2 target=$3 distance=$4 yaw=$5 pitch=$6
    shift 6
    cat >"$sets/view.sesession" <<EOF
{"format": "spiraling-edge session", "version": 1,
 "input": {"source": "$sets/$set.ply"}, "options": {"rules": "robust", "reach": 1.6},
 "address": "0", "layout": "present", "layers": {$kept_out},
 "camera": {"target": [$target], "distance": $distance, "yaw": $yaw, "pitch": $pitch}}
EOF
    "$viewer" "$sets/view.sesession" --no-config --theme light --ui-scale 0.75 --size 1440x1118 \
        --goto 100% "$@" --screenshot "$sets/view.png"
    convert "$sets/view.png" -crop 1300x880+20+60 +repage -filter Lanczos -resize 650x440 \
        +dither -colors 128 -strip -define png:compression-level=9 "PNG8:$picture"
}

figures() {
    sets=$(mktemp -d)
    trap 'rm -r "$sets"' EXIT
    "$(dirname "$viewer")/spiraling-edge" table1 --volumes "$1" --save "$sets" >"$sets/table.txt"
    figure 21 hydrogen 0,0,0 4.35 -60 18
    figure 22 lobster 0,0,-0.04 2.7 25 24
    figure 23 hyperboloid 0,0,0 3.9 -60 14
    figure 24 blast_wave 0,0,-0.2 3.4 145 33
    figure 25 electron_cloud 0,0,0 3.9 -60 22
}

# The page on which points spread, at a step on the way.
new_points() {
    "$viewer" --new gyroid -n 3000 --steps 40 --no-config --size 1280x800 --screenshot images/new-points.png
    convert images/new-points.png +dither -colors 160 -strip -define png:compression-level=9 PNG8:images/new-points.png
}

if [ "${2:-}" = table1 ]; then
    figures "$3"
    exit
fi
if [ "${2:-}" = new ]; then
    new_points
    exit
fi
stages
[ "${2:-}" = stages ] && exit
new_points
"$viewer" scene:torus --no-config --size 1440x810 --goto 50% --screenshot images/viewer.png
"$viewer" scene:torus --no-config --size 1280x720 --layout compare --with "--rule freesector=off" --goto difference --focus \
    --screenshot images/compare.png
convert images/compare.png +dither -colors 128 -strip -define png:compression-level=9 PNG8:images/compare.png
./make-rule-pictures.sh "$(dirname "$viewer")/spiraling-edge"
