#!/usr/bin/env bash
# Installs the package by pip into an environment of its own, as docs/python.md says, from a checkout with only what
# that needs.
#   pip_test.sh PYTHON CHECKOUT BUILD FOLDER
# Objects of the library and of the painter are those of BUILD, where it has the same: they are not compiled again.
set -euo pipefail
python=$1 source=$2 build=$3 folder=$4
renice -n 19 $$ >/dev/null  # the tests of the window depend on a clock
rm -rf "$folder"
mkdir -p "$folder/checkout/app"
cd "$folder"
"$python" -m venv --system-site-packages venv || { echo "skipped: python3-venv is not installed"; exit 77; }
ln -s "$source/core" checkout/core
ln -s "$source/CMakeLists.txt" checkout/CMakeLists.txt
ln -s "$source/app/viewer" checkout/app/viewer
cp -a "$source/app/python" checkout/app
cat >compile <<SH
#!/usr/bin/env bash
# The compiler of the package: COMMAND... -MF DEPENDENCIES -o OBJECT ...
for word; do
    case \${before-} in -o) object=\$word ;; -MF) needs=\$word ;; esac
    before=\$word
done
if [[ \${object-} == @(core|app/viewer)/* && -f "$build/\$object" ]]; then
    cp "$build/\$object" "\$object" && echo "\$object:" >"\$needs"
else
    exec $(command -v ccache || true) "\$@"
fi
SH
chmod +x compile
# Compiled fast, since it runs once.
export CMAKE_ARGS="-G Ninja '-DCMAKE_CXX_FLAGS_RELEASE=-O0 -DNDEBUG' '-DCMAKE_CXX_COMPILER_LAUNCHER=$folder/compile'"
venv/bin/pip install --no-index --no-build-isolation ./checkout/app/python
unset PYTHONPATH
venv/bin/python - <<'PYTHON'
import importlib.metadata
import spiraling_edge as se
assert importlib.metadata.version("spiraling-edge") == se.__version__
assert "venv" in se.__file__, se.__file__
mesh = se.reconstruct("scene:torus")
assert mesh.verdict.sound, mesh.verdict.headline
assert mesh.png() and se.Run("scene:torus").state.svg()
PYTHON
