#!/usr/bin/env bash
# Installs the package by pip into an environment of its own, as docs/python.md says.
#   pip_test.sh PYTHON CHECKOUT
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$2"
"$1" -m venv --system-site-packages "$folder/venv" || { echo "skipped: no python3-venv"; exit 77; }
"$folder/venv/bin/pip" --version >/dev/null 2>&1 || { echo "skipped: no pip"; exit 77; }
before=$(git status --porcelain --ignored app/python 2>/dev/null || true)
"$folder/venv/bin/pip" install --no-index --no-build-isolation ./app/python
cd "$folder"
env -u PYTHONPATH venv/bin/python - <<'PYTHON'
import spiraling_edge as se
assert "venv" in se.__file__, se.__file__
mesh = se.reconstruct("scene:torus")
assert mesh.verdict.sound, mesh.verdict.headline
PYTHON
cd "$2"
after=$(git status --porcelain --ignored app/python 2>/dev/null || true)
[ "$before" = "$after" ] || { echo "FAIL: the checkout has other files: $after"; exit 1; }
