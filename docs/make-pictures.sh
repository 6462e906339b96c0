#!/usr/bin/env bash
# Makes the pictures of README.md and the pages here. Needs no display, but ImageMagick's convert.
#   docs/make-pictures.sh [VIEWER]          all of them
#   docs/make-pictures.sh VIEWER stages     those of every stage (docs/viewer.md) alone
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

stages() {
    stage seed linked-tori 537.seed.1
    stage strand sphere 425.strand.1 --focus
    stage skip figure-14 15.skip.1 --focus
    stage insert figure-14 1.insert.1 --focus
    stage insert-corner figure-14 31.insert.1 --focus
    stage sort torus 333.sort.9 --focus
    stage sort-beyond sphere 100.sort.8 --focus
    stage sort-tie grid 4.sort.13 --focus
    stage limits figure-4 8.limits.3 --focus
    stage convex torus 419.convex.1 --focus
    stage reciprocal figure-9 42.reciprocal.1 --focus
    stage hole figure-7 95.hole.1 --focus
    stage sphere-inside sphere 30.sphere.1 --focus
    stage sphere-removed sphere 30.sphere.2 --focus
    stage sphere-gap figure-5 29.sphere.4 --focus
    stage twopoint figure-9 15.twopoint.1 --focus
    stage twopoint-over figure-9 87.twopoint.1 --focus
    stage emit sphere 30.emit.2 --focus
    stage ring sphere 14.ring.4 --focus
    stage split figure-12 35.split.1 --focus
    stage split-second figure-12 35.split.2 --focus
    stage join figure-12 74.join.1 --focus
    stage advance sphere 14.advance.1 --focus
    stage done linked-tori 536.done.1
    stage done-rim sheet 777.done.64
}

# FIGURE SET: a set of Table 1, triangulated.
figure() {
    local picture="images/figure-$1.png"
    "$viewer" "$sets/$2.ply" --no-config --layout present --theme light --size 900x560 --rules robust \
        --goto 100% --screenshot "$picture"
    # The view alone, in few colors.
    convert "$picture" -crop 640x420+115+4 +repage +dither -colors 64 -strip -define png:compression-level=9 \
        "PNG8:$picture"
}

figures() {
    sets=$(mktemp -d)
    "$(dirname "$viewer")/spiraling-edge" table1 --volumes "$1" --save "$sets" >"$sets/table.txt"
    figure 21 hydrogen
    figure 22 lobster
    figure 23 hyperboloid
    figure 24 blast_wave
    figure 25 electron_cloud
    rm -r "$sets"
}

if [ "${2:-}" = table1 ]; then
    figures "$3"
    exit
fi
stages
[ "${2:-}" = stages ] && exit
"$viewer" scene:torus --no-config --size 1440x810 --goto 50% --screenshot images/viewer.png
./make-rule-pictures.sh "$(dirname "$viewer")/spiraling-edge"
