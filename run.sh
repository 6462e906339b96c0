#!/usr/bin/env bash
# Installs missing packages, builds, and opens the viewer.
#   ./run.sh [FILE] [VIEWER OPTIONS]
# FILE: points as PLY, XYZ, OBJ, OFF or PCD, or scene:ID. Without one, a scan of a kitten that Debian
# ships, or a built-in scene if it cannot be fetched, is triangulated in twenty seconds. Without a
# display, the same is run headless: report to the terminal, mesh and picture to out/.
set -euo pipefail
root=$(cd "$(dirname "$0")" && pwd)

case "${1:-}" in
    -h | --help) sed -n '2,6s/^# \{0,1\}//p' "$0"; exit 0 ;;
    "" | -*) input= ;;
    scene:*) input=$1; shift ;;
    *)
        [ -f "$1" ] || { echo "run.sh: $1: there is no such file" >&2; exit 3; }
        input=$(realpath -- "$1")
        shift
        ;;
esac

say() { echo "run.sh: $*" >&2; }

cd "$root"
.ci/packages.sh run
if [ ! -f build/build.ninja ]; then
    cmake --preset release >build-configure.log 2>&1 || { cat build-configure.log >&2; exit 1; }
    rm -f build-configure.log
fi
[ -x build/bin/spiraling-edge-viewer ] || say "building: a few minutes, the first time"
cmake --build build >&2

first=()
if [ -z "$input" ]; then
    first=(--play 20)
    [ -e assets/scans/kitten.xyz ] || timeout 120 assets/fetch-scans.sh >&2 || true
    input=assets/scans/kitten.xyz
    if [ ! -e "$input" ]; then
        input=$(build/bin/spiraling-edge scenes | head -1 | cut -d' ' -f1)
        say "the scan of the kitten cannot be fetched: opening $input"
    fi
fi

viewer=build/bin/spiraling-edge-viewer
if [ -n "${DISPLAY:-}" ]; then
    code=0
    "$viewer" "$input" "${first[@]}" "$@" || code=$?
    [ "$code" = 4 ] || exit "$code"
    say "no window can be opened here"
fi

name=$(basename "${input#scene:}")
name=${name%.*}
mkdir -p out
say "there is no display: running $input headless"
build/bin/spiraling-edge run "$input" -o "out/$name.ply" --report -
say "the mesh is in out/$name.ply"
[[ " $* " == *" --goto "* ]] || set -- "$@" --goto 100% # the end of the run by default
"$viewer" "$input" --screenshot "out/$name.png" "$@"
say "the picture is in out/$name.png"
