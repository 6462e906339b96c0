#!/usr/bin/env bash
# Runs the lines of docs/python.md that use the package of a build, and that install it.
#   install_test.sh PYTHON CHECKOUT BUILD
set -euo pipefail
python=$1 page=$2/docs/python.md build=$3
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
mkdir "$folder/bin"
ln -s "$python" "$folder/bin/python3"
ln -s "$build" "$folder/build"
export PATH=$folder/bin:$PATH DESTDIR=$folder/root
cd "$folder"
line() { grep -F "$1" "$page"; }
bash -ec "$(line 'PYTHONPATH=build/python ')"
bash -ec "$(line 'cmake --install build --component python')" >/dev/null
installed=$(dirname "$(dirname "$(find root -name 'py.typed')")")
[ "$(find root -name '*.a' -o -name 'spiraling-edge*')" = "" ] || { echo "FAIL: more than the package is installed"; exit 1; }
PYTHONPATH=$folder/$installed python3 -c "import spiraling_edge as se; assert 'root' in se.__file__; print(len(se.scenes()))"
! readelf -d "$installed"/spiraling_edge/_core*.so | grep -E 'RPATH|RUNPATH'
