#!/usr/bin/env bash
# Makes the pictures of README.md and the pages here. Needs no display, but ImageMagick's convert.
#   docs/make-pictures.sh [VIEWER]          all of them
#   docs/make-pictures.sh VIEWER stages     those of every stage alone: the steps of story.lesson.md, exported
#   docs/make-pictures.sh VIEWER new        that of the page with new points alone
#   docs/make-pictures.sh VIEWER table1 DIR  the paper's Figures 21 to 25 (docs/performance.md); DIR has the volumes
# Windows with their panels (viewer.png, new-points.png) are screenshots, since an export has the view alone; those of
# rules are drawn by make-rule-pictures.sh.
set -euo pipefail
cd "$(dirname "$0")"
viewer=${1:-../build/bin/spiraling-edge-viewer}
program=$(dirname "$viewer")/spiraling-edge
mkdir -p images

# FILE: in few colors, as small as its content allows.
shrink() {
    convert "$1" +dither -colors "${2:-144}" -strip -define png:compression-level=9 "PNG8:$1"
}

# One picture of each step of story.lesson.md: the one named "Sort beyond" is stage-sort-beyond.png. The last one, of
# two runs, is larger.
story() {
    local folder file place title last
    folder=$(mktemp -d)
    last=$(grep -c '^## ' story.lesson.md)
    "$program" export story.lesson.md -o "$folder/" --size 900x560 --steps "1-$((last - 1))"
    while IFS=$'\t' read -r file place title; do
        title=${title%%:*}
        title=${title,,}
        mv "$folder/$file" "images/stage-${title// /-}.png"
        shrink "images/stage-${title// /-}.png"
        echo "stage-${title// /-}.png: $place"
    done <"$folder/captions.txt"
    "$program" export story.lesson.md -o "$folder/" --size 1280x640 --steps "$last"
    mv "$folder/001.png" images/compare.png
    shrink images/compare.png
    rm -r "$folder"
}

# NAME SCENE ADDRESS [OPTION...]: as a step, for neighbor lists that a step of a lesson cannot choose.
stage() {
    local name=$1 scene=$2 address=$3
    shift 3
    "$viewer" "scene:$scene" --no-config --background theme --size 900x560 --goto "$address" "$@" \
        --screenshot "images/stage-$name.png"
    shrink "images/stage-$name.png"
}

# NAME SCENE ADDRESS X,Y,Z DISTANCE YAW PITCH [OPTION...]: the same as seen from there.
stage_from() {
    local name=$1 scene=$2 address=$3 target=$4 distance=$5 yaw=$6 pitch=$7
    shift 7
    stage "$name" "$scene" "$address" --place "{\"address\": \"$address\", \"camera\": {
        \"target\": [$target], \"distance\": $distance, \"yaw\": $yaw, \"pitch\": $pitch}}" "$@"
}

stages() {
    story
    stage_from hole linked-tori 120.hole.2 0.668,0.207,0.40 0.5 62 25 --neighbors 24
    stage done-alert genus-2 630.done.7 --neighbors 24 --focus
    stage fill linked-tori 600.fill.1 --focus --neighbors 24 --rule fill=on
    stage_from reinsert long-lists 143.reinsert.1 0.30,0.68,0.26 1.15 25 35 --neighbors 16 --rules robust \
        --rule opposingfrom=90
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
    "$program" table1 --volumes "$1" --save "$sets" >"$sets/table.txt"
    figure 21 hydrogen 0,0,0 4.35 -60 18
    figure 22 lobster 0,0,-0.04 2.7 25 24
    figure 23 hyperboloid 0,0,0 3.9 -60 14
    figure 24 blast_wave 0,0,-0.2 3.4 145 33
    figure 25 electron_cloud 0,0,0 3.9 -60 22
}

# The page on which points spread, at a step on the way.
new_points() {
    "$viewer" --new gyroid -n 3000 --steps 40 --no-config --size 1280x800 --screenshot images/new-points.png
    shrink images/new-points.png 160
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
# The first command of README.md.
"$viewer" scene:torus --no-config --size 1440x810 --goto 137.sphere.3 --screenshot images/viewer.png
shrink images/viewer.png 256
./make-rule-pictures.sh "$program"
