#!/usr/bin/env bash
# What the program makes, as hashes: for every scene, and for each FILE, by `paper` and `robust`, the mesh, the
# report but for its seconds, and the state; of up to 6,000 points also the trace and what other verbs say.
#   tests/agreement/pins.sh PROGRAM [FILE...] >before.txt     ... and after a change that must alter nothing: diff
set -uo pipefail
[ $# -ge 1 ] || { echo "usage: $0 PROGRAM [FILE...]" >&2; exit 2; }
program=$(realpath "$1")
shift
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
inputs=()
for file in "$@"; do inputs+=("$(realpath "$file")"); done
cd "$work" || exit 2  # Reports name the files.

hash() { sha256sum | cut -c1-16; }
# said NAME COMMAND...: the hash of what a command says, and its exit code.
said() {
    local name=$1 code=0 sum
    shift
    sum=$("$@" 2>/dev/null </dev/null | sed -E '/"seconds"|[0-9.]+ s\b|^ *"(read|trials|prepare|judge|triangulate|write|normals|orientation|types|rim|neighbors)": [0-9.e-]+,?$/d' | hash) || code=$?
    printf ' %s %s' "$name" "$sum"
    [ "$code" = 0 ] || printf ' (%s)' "$code"
}

# pin INPUT: a line for each set of rules.
pin() {
    local input=$1 rules points
    for rules in paper robust; do
        "$program" run "$input" --rules "$rules" -q -o mesh.ply --report report.json 2>/dev/null </dev/null
        points=$(sed -nE 's/^  "points": ([0-9]+),$/\1/p' report.json 2>/dev/null)
        printf '%s %s state %s mesh %s' "$(basename "$input")" "$rules" \
            "$(sed -nE 's/^  "state_hash": "(.*)",$/\1/p' report.json)" "$(hash <mesh.ply)"
        said report cat report.json
        said check "$program" check mesh.ply --points "$input" --json
        if [ "${points:-0}" -le 6000 ]; then
            "$program" run "$input" --rules "$rules" -q --trace trace >/dev/null 2>&1 </dev/null
            printf ' trace %s' "$(hash <trace)"
            said options "$program" run "$input" --rules "$rules" -q --report - --rule fill=on --derive-normals \
                --reach 2.5 --symmetric --keep-opposing --keep-noise --keep-strays --derive-rim --box auto
            said why "$program" why "$input" --rules "$rules" --failures --json
            said doctor "$program" doctor "$input" --json
            said info "$program" info "$input"
            said best "$program" run "$input" --rules "$rules" --best -q --report - -o best.ply
            said compare "$program" compare "$input" --rules "$rules" --with --rules corrected
        fi
        echo
    done
}

"$program" scenes | grep -oE '^scene:[a-z0-9-]+' | while read -r scene; do pin "$scene"; done
for file in ${inputs[@]+"${inputs[@]}"}; do pin "$file"; done
