#!/usr/bin/env bash
# Files that go to other programs and come back. A case whose program is not installed is skipped
# (exit code 77).
#   foreign_test.sh PROGRAM CASE    runs one case, in an empty folder of its own
set -uo pipefail
program=$(realpath "$1")
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder" || exit 1
failed=0

fail() {
    echo "FAIL: $*"
    failed=1
}
is() { [ "$1" = "$2" ] || fail "$3: $1, not $2"; }
needs() {
    command -v "$1" >/dev/null && return
    echo "skipped: no \`$1\` here; on Debian it is in the package $2"
    exit 77
}
make() { "$program" run scene:sphere --rules robust -q -o "$1" || fail "cannot write $1"; }
# The sphere has 600 points; closed, it has 2 * 600 - 4 triangles.
points=600
triangles=1196

# field NAME: a number of what `assimp info` said.
field() { sed -n "s/^$1: *\\([0-9]*\\).*/\\1/p" said | head -1; }

assimp_reads_what_is_written() {
    needs assimp assimp-utils
    local kind
    for kind in ply obj off stl glb; do
        make "sphere.$kind"
        assimp info "sphere.$kind" >said 2>&1 || fail "assimp refuses $kind: $(tail -3 said)"
        is "$(field Faces)" $triangles "triangles of $kind"
        # STL holds three corners per triangle and does not say which are the same.
        if [ "$kind" = stl ]; then
            is "$(field Vertices)" $((3 * triangles)) "corners of $kind"
        else
            is "$(field Vertices)" $points "points of $kind"
        fi
    done
}

assimp_writes_what_is_read() {
    needs assimp assimp-utils
    make sphere.ply
    local kind
    # plyb is assimp's name of a binary PLY.
    for kind in ply plyb obj; do
        assimp export sphere.ply "back.${kind/plyb/ply}" "-f$kind" >said 2>&1 ||
            fail "assimp cannot write $kind: $(tail -3 said)"
        "$program" info "back.${kind/plyb/ply}" >out 2>&1 || fail "$kind is refused: $(cat out)"
        grep -qF ": $points points" out || fail "points of $kind: $(head -1 out)"
        grep -qF "$triangles triangles in 1 component, no boundary" out ||
            fail "triangles of $kind: $(cat out)"
        "$program" run "back.${kind/plyb/ply}" --rules robust -q -o again.obj ||
            fail "cannot run on $kind"
        is "$(grep -c '^f ' again.obj)" $triangles "triangles made anew from $kind"
    done
}

admesh_finds_no_fault() {
    needs admesh admesh
    make sphere.stl
    admesh --no-check sphere.stl >/dev/null 2>&1 || fail "admesh refuses the file"
    admesh sphere.stl >said 2>&1
    grep -qE "^Number of facets +: +$triangles +$triangles" said || fail "facets: $(cat said)"
    local fault
    for fault in "Total disconnected facets" "Degenerate facets" "Edges fixed" "Facets removed" \
        "Facets reversed" "Normals fixed"; do
        grep -qE "^$fault +: +0( |\$)" said || fail "$fault: $(grep -F "$fault" said)"
    done
}

case $2 in
    assimp_reads_what_is_written | assimp_writes_what_is_read | admesh_finds_no_fault) "$2" ;;
    *) fail "no case '$2'" ;;
esac
exit $failed
