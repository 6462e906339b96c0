#!/usr/bin/env bash
# Saving the mesh, and copying the command that makes it: Ctrl+E, formats, points, the question before a
# file is replaced. The saved file equals that of the command line.
. "$(dirname "$0")/harness.sh"
cli=$(dirname "$viewer")/spiraling-edge
[ -x "$cli" ] || { echo "skipped: no spiraling-edge beside the viewer"; exit 77; }
PATH=$(dirname "$cli"):$PATH
out="$work/my meshes"
mkdir "$out"
cd "$out" || fail "no folder"
# enter: Return, once the line with the name has the keyboard focus.
enter() { says typing true; press Return; }
# run_copied FILE: the last copied command writes FILE, which equals the saved one.
run_copied() {
    mv "$1" "$work/saved" || fail "nothing was saved as $1"
    sh -c "$(field mesh_command)" 2>"$work/err.txt" || fail "the copied command fails: $(cat "$work/err.txt")"
    cmp "$1" "$work/saved" || fail "the copied command writes another $1"
}

# Nothing is open: a sentence, and no dialog.
start; says start_page true
press ctrl+e; says message "There is no run to save the mesh of\."; says mesh_dialog false
stop

# A name is proposed; Enter saves the final mesh of the run, and the cursor stays.
start scene:stranded-point --goto 5 --rules corrected --rule maxgap=110; says phase ready; says pivot 5
press ctrl+e; says mesh_dialog true
says mesh_name 'stranded-point-mesh\.ply'; says mesh_triangles '[1-9][0-9]*'
enter; says mesh_dialog false; says message 'Saved .* triangles and .*stranded-point-mesh\.ply\.'
says pivot 5
"$cli" run scene:stranded-point --rules corrected --rule maxgap=110 -q -o "$work/cli.ply" || fail "the command line fails"
cmp "$work/cli.ply" "$out/stranded-point-mesh.ply" || fail "the command line writes another mesh"

# The second time: a question. Esc, and Enter on the answer with the focus, keep the file.
echo old >"$out/stranded-point-mesh.ply"
press ctrl+e; says mesh_dialog true; says mesh_name 'stranded-point-mesh\.ply'; says mesh_triangles '[1-9][0-9]*'
enter; says mesh_question '.*stranded-point-mesh\.ply'
press Escape; says mesh_question ""; says mesh_dialog true
enter; says mesh_question '.*stranded-point-mesh\.ply'
press Return; says mesh_question ""; says mesh_dialog true
[ "$(cat "$out/stranded-point-mesh.ply")" = old ] || fail "the file was replaced without an answer"
enter; says mesh_question '.*stranded-point-mesh\.ply'
click_on "mesh replace"; says mesh_dialog false
cmp "$work/cli.ply" "$out/stranded-point-mesh.ply" || fail "Replace does not replace"

# A format changes the name, a name the format; used points only; the command that was copied writes the same.
press ctrl+e; says mesh_dialog true; says mesh_triangles '[1-9][0-9]*'
click_on "mesh OBJ"; says mesh_name 'stranded-point-mesh\.obj'; says mesh_format '\.obj'
click_on "mesh used points"; says mesh_used_only true
click_on "mesh copy command"; says mesh_command 'spiraling-edge run scene:stranded-point --rules corrected .*--used-points .*'
[ -e "$out/stranded-point-mesh.obj" ] && fail "copying the command saves"
enter; says mesh_dialog false
run_copied stranded-point-mesh.obj
press ctrl+e; says mesh_dialog true
says typing true; type_text "other.off"; says mesh_name 'other\.off'; says mesh_format '\.off'
enter; says mesh_dialog false
[ -s "$out/other.off" ] || fail "no OFF is written"

# From the list of actions: the command for the file that was saved last.
press ctrl+p; says palette true; type_text "copy command"; press Return; says palette false
says message 'Copied the command\.'; says mesh_command ".*other\.off'?"
run_copied other.off

# Columns of faults, which PLY alone holds.
press ctrl+e; says mesh_dialog true; says mesh_triangles '[1-9][0-9]*'
click_on "mesh fault fields"; says mesh_fault_fields false
click_on "mesh PLY"; click_on "mesh fault fields"; says mesh_fault_fields true
click_on "mesh copy command"; says mesh_command 'spiraling-edge run .* --fault-fields .*'
enter; says mesh_dialog false
run_copied other.ply
press ctrl+e; says mesh_dialog true; click_on "mesh fault fields"; says mesh_fault_fields false
press Escape; says mesh_dialog false

# A write error is reported in the dialog, and another name works.
press ctrl+e; says mesh_dialog true; says mesh_triangles '[1-9][0-9]*'
says typing true; type_text "none/a.ply"; says mesh_name 'none/a\.ply'
enter; says mesh_complaint '.*there is no folder.*'; says mesh_dialog true
says typing true; type_text "again.stl"; says mesh_name 'again\.stl'
enter; says mesh_dialog false
[ -s "$out/again.stl" ] || fail "the other name is not written"
stop

# Sampled points: the command makes the points first.
start sample:torus,n=300 --neighbors 10; says phase ready
press ctrl+e; says mesh_dialog true; says mesh_name 'torus-300-mesh\.ply'; says mesh_triangles '[1-9][0-9]*'
click_on "mesh copy command"; says mesh_command 'spiraling-edge sample torus .* && spiraling-edge run .*'
enter; says mesh_dialog false
run_copied torus-300-mesh.ply
# It is on the clipboard.
press ctrl+e; says mesh_dialog true; says mesh_name 'torus-300-mesh\.ply'
says typing true; press ctrl+a ctrl+v; says mesh_name 'spiraling-edge sample torus .*'
press Escape; says mesh_dialog false
stop
well
