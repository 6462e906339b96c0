#!/usr/bin/env bash
# Builds the program for the browser, on Debian 12:
#   build-web/site/                 for any server that serves files
#   build-web/spiraling-edge.html   the same as one file, which opens from a disk
#   build.sh [-j N] [-p PROGRAM]
# PROGRAM: a spiraling-edge beside its viewer, which draws the pages before the program, and gets the file beside it (default:
# built in build/)
set -euo pipefail
root=$(cd "$(dirname "$0")/../.." && pwd)
jobs=$(nproc)
program=
while getopts j:p: option; do
    case $option in
        j) jobs=$OPTARG ;;
        p) program=$(realpath "$OPTARG") ;;
        *) sed -n '2,7s/^# \{0,1\}//p' "$0" >&2; exit 2 ;;
    esac
done
cd "$root"
.ci/packages.sh web
app/web/parts.sh build-web/parts
export NODE_PATH=/usr/share/nodejs  # where Debian's Emscripten finds its parser
cmake --preset web >build-web/configure.log 2>&1 || { cat build-web/configure.log >&2; exit 1; }
cmake --build --preset web --parallel "$jobs"
if [ -z "$program" ]; then
    if [ ! -f build/build.ninja ]; then cmake --preset release >/dev/null; fi
    cmake --build build --target spiraling-edge spiraling-edge-viewer --parallel "$jobs"
    program=build/bin/spiraling-edge
fi
version=$(sed -n 's/^project(spiraling_edge VERSION \([0-9]*\.[0-9]*\).*/\1/p' CMakeLists.txt)
/usr/bin/python3 app/web/site.py build-web/build/bin build-web/site build-web/spiraling-edge.html "$version" "$program"
cp build-web/spiraling-edge.html "$(dirname "$program")"  # for `export --app`
echo "build-web/site and build-web/spiraling-edge.html"
