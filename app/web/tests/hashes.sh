#!/usr/bin/env bash
# Decisions in WebAssembly: every scene and every file of assets/points, by four sets of rules, must give
# the state and the triangles that the native program gives.
#   hashes.sh NATIVE WEB     NATIVE: spiraling-edge; WEB: spiraling-edge.js, run by Node.js
set -euo pipefail
root=$(cd "$(dirname "$0")/../../.." && pwd)
native=$(realpath "$1")
web=$(realpath "$2")
cd "$root"

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# results PROGRAM...: a line for each run
results() {
    local input rules
    for input in $("$native" scenes | cut -d' ' -f1) assets/points/*.ply; do
        for rules in paper printed corrected robust; do
            rm -f "$work/mesh.ply"
            echo "$input $rules $("$@" run "$input" --rules "$rules" -o "$work/mesh.ply" --report - -q 2>&1 </dev/null |
                grep -oE '"state_hash": [^,]*' || true) mesh $(sha256sum <"$work/mesh.ply" | cut -c1-16)"
        done
    done
}
results "$native" >"$work/native"
# Node.js from 18 on has a fetch of its own, which this Emscripten takes for a browser's.
results node --no-experimental-fetch "$web" >"$work/web"
runs=$(wc -l <"$work/native")
[ "$(grep -c '"state_hash"' "$work/native")" = "$runs" ] || { echo "the native program gave no hash for some"; exit 1; }
diff "$work/native" "$work/web" || exit 1
echo "$runs runs: the same states and triangles in WebAssembly and native"
