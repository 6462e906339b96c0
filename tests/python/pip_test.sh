#!/usr/bin/env bash
# Installs the package by pip into an environment of its own, as docs/python.md says, from a checkout with only what
# that needs.
#   pip_test.sh PYTHON CHECKOUT FOLDER
# FOLDER keeps what is built, for the next time.
set -euo pipefail
python=$1 source=$2 folder=$3
renice -n 19 $$ >/dev/null  # the tests of the window depend on a clock
mkdir -p "$folder/checkout/app"
cd "$folder"
rm -rf venv
"$python" -m venv --system-site-packages venv || { echo "skipped: python3-venv is not installed"; exit 77; }
ln -sfn "$source/core" checkout/core
ln -sfn "$source/CMakeLists.txt" checkout/CMakeLists.txt
cp -a --update "$source/app/python" checkout/app
# Compiled fast, since it runs once.
export CMAKE_ARGS='-G Ninja "-DCMAKE_CXX_FLAGS_RELEASE=-O0 -DNDEBUG"'
venv/bin/pip install --no-index --no-build-isolation ./checkout/app/python
unset PYTHONPATH
venv/bin/python - <<'PYTHON'
import importlib.metadata
import spiraling_edge as se
assert importlib.metadata.version("spiraling-edge") == se.__version__
assert "venv" in se.__file__, se.__file__
mesh = se.reconstruct("scene:torus")
assert mesh.verdict.sound, mesh.verdict.headline
PYTHON
