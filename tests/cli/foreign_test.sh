#!/usr/bin/env bash
# Files that go to other programs and come back. A case whose program is not installed is skipped
# (exit code 77).
#   foreign_test.sh PROGRAM CASE    runs one case, in an empty folder of its own
set -uo pipefail
program=$(realpath "$1")
. "$(dirname "$0")/../support/one_case.sh"
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

# field NAME: a number of `assimp info` printed.
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
    # With a b at its end: binary, in assimp's words.
    local file
    for kind in ply plyb obj stl stlb glb2; do
        file=back.${kind%b}
        [ $kind = obj ] && file=back.obj
        [ $kind = glb2 ] && file=back.glb
        assimp export sphere.ply "$file" "-f$kind" >said 2>&1 ||
            fail "assimp cannot write $kind: $(tail -3 said)"
        "$program" info "$file" >out 2>&1 || fail "$kind is refused: $(cat out)"
        grep -qF ": $points points" out || fail "points of $kind: $(head -1 out)"
        grep -qF "$triangles triangles in 1 component, no boundary" out ||
            fail "triangles of $kind: $(cat out)"
        "$program" run "$file" --rules robust -q -o again.obj ||
            fail "cannot run on $kind"
        is "$(grep -c '^f ' again.obj)" $triangles "triangles made again from $kind"
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

# Points to PCL and back, as text, as bytes and compressed; the mesh made of them is the same.
pcl_reads_points_and_writes_them() {
    needs pcl_ply2pcd pcl-tools
    make sphere.ply
    local format
    for format in 0 1 2; do
        pcl_ply2pcd -format 1 sphere.ply bytes.pcd >said 2>&1 || fail "PCL refuses PLY: $(tail -3 said)"
        pcl_convert_pcd_ascii_binary bytes.pcd back.pcd $format >said 2>&1 ||
            fail "PCL cannot write format $format: $(tail -3 said)"
        "$program" info back.pcd >out 2>&1 || fail "PCD $format is refused: $(cat out)"
        grep -qF ": $points points" out || fail "points of PCD $format: $(head -1 out)"
        grep -qE '^ +normals +yes' out || fail "normals of PCD $format: $(cat out)"
        "$program" run back.pcd --rules robust -q -o again.ply || fail "cannot run on PCD $format"
        "$program" info again.ply | grep -qF "$triangles triangles in 1 component, no boundary" ||
            fail "the mesh made again from PCD $format"
    done
    # As text: binary PCL 1.13 writes normals as doubles where its header says float.
    pcl_pcd2ply -format 0 back.pcd pcl.ply >said 2>&1 || fail "PCL cannot write PLY: $(tail -3 said)"
    "$program" info pcl.ply 2>&1 | grep -qF ": $points points" || fail "the PLY of PCL is refused"
}

# Not OBJ: the reader of Debian 12's MeshLab fails an assertion on any, even one of four lines.
meshlab_reads_what_is_written() {
    needs meshlabserver meshlab
    needs xvfb-run xvfb
    local kind
    for kind in ply off stl; do
        make "sphere.$kind"
        xvfb-run -a meshlabserver -i "sphere.$kind" -o "back.ply" >said 2>&1 ||
            fail "MeshLab refuses $kind: $(tail -3 said)"
        # It joins the corners of STL that are the same.
        grep -qF "sphere.$kind loaded has $points vn $triangles fn" said || fail "$kind: $(cat said)"
        "$program" info back.ply >out 2>&1 || fail "MeshLab's PLY is refused: $(cat out)"
        grep -qF "$triangles triangles in 1 component, no boundary" out ||
            fail "MeshLab's PLY of $kind: $(cat out)"
    done
}

meshio_reads_and_writes_meshes() {
    /usr/bin/python3 -c 'import meshio' 2>/dev/null || {
        echo "skipped: no meshio here; on Debian it is in the package python3-meshio"
        exit 77
    }
    local kind
    for kind in ply obj off stl; do make "sphere.$kind"; done
    "$program" run sphere.obj -q --fault-fields -o fields.ply >out 2>&1 || fail "fields: $(cat out)"
    /usr/bin/python3 - >said 2>&1 <<'PYTHON' || fail "meshio: $(tail -3 said)"
import meshio
for kind in ("ply", "obj", "off", "stl"):
    mesh = meshio.read(f"sphere.{kind}")
    assert [len(mesh.points), len(mesh.cells_dict["triangle"])] == [600, 1196], (kind, mesh)
    meshio.write(f"back.{kind}", meshio.Mesh(mesh.points, mesh.cells))
fields = meshio.read("fields.ply").point_data
assert len(fields["scalar_se_fault"]) == len(fields["scalar_se_distance"]) == 600, fields
assert max(fields["scalar_se_fault"]) > 0 and max(fields["scalar_se_distance"]) > 0, fields
meshio.write("text.ply", meshio.Mesh(mesh.points, mesh.cells), binary=False)
meshio.write("bytes.stl", meshio.Mesh(mesh.points, mesh.cells), binary=True)
PYTHON
    local file
    for file in back.* text.ply bytes.stl; do
        "$program" info "$file" >out 2>&1 || fail "$file is refused: $(cat out)"
        grep -qF ": $points points" out || fail "points of $file: $(head -1 out)"
        grep -qF "$triangles triangles in 1 component, no boundary" out ||
            fail "triangles of $file: $(cat out)"
    done
}

case $2 in
    assimp_reads_what_is_written | assimp_writes_what_is_read | admesh_finds_no_fault) "$2" ;;
    pcl_reads_points_and_writes_them | meshlab_reads_what_is_written) "$2" ;;
    meshio_reads_and_writes_meshes) "$2" ;;
    *) fail "no case '$2'" ;;
esac
exit "$failed"
