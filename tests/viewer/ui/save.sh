#!/usr/bin/env bash
# Saving the mesh from the window: a proposed name, the question before a file is replaced, a format by a click, and
# the copied command, which writes the same file.
. "$(dirname "$0")/harness.sh"
cli=$(dirname "$viewer")/spiraling-edge
[ -x "$cli" ] || { echo "skipped: no spiraling-edge beside the viewer"; exit 77; }
PATH=$(dirname "$cli"):$PATH
out="$work/my meshes"
mkdir "$out"
cd "$out" || fail "no folder"
# enter: Return, once the line with the name has the keyboard focus.
enter() { says typing true; press Return; }
ask_to_save() { press ctrl+e; says mesh_dialog true; says mesh_triangles '[1-9][0-9]*'; }

start; says start_page true
press ctrl+e; says message "There is no run to save the mesh of\."; says mesh_dialog false
press ctrl+shift+e; says message "There is nothing open to export\."; says export_dialog false
stop

start scene:stranded-point --goto 5 --rules corrected --rule maxgap=110; says phase ready; says pivot 5
ask_to_save; says mesh_name 'stranded-point-mesh\.ply'
enter; says mesh_dialog false; says message 'Saved .* triangles and .*stranded-point-mesh\.ply\.'
says pivot 5
# The second time it is replaced only on request, like any other file.
mv stranded-point-mesh.ply "$work/first.ply"
echo old >stranded-point-mesh.ply
ask_to_save
enter; says mesh_question '.*exists already.*'
press Escape; says mesh_dialog false
ask_to_save
enter; says mesh_question '.*exists already.*'
[ "$(cat stranded-point-mesh.ply)" = old ] || fail "the file was replaced without an answer"
enter; says mesh_dialog false
cmp "$work/first.ply" stranded-point-mesh.ply || fail "the file was not replaced"

# A format changes the name, choices are clicked; the command on the clipboard writes the same.
ask_to_save
click_on "mesh fault fields"; says mesh_fault_fields true
click_on "mesh fault fields"; says mesh_fault_fields false
click_on "mesh OBJ"; says mesh_name 'stranded-point-mesh\.obj'; says mesh_format '\.obj'
click_on "mesh used points"; says mesh_used_only true
click_on "mesh copy command"; says copied 'spiraling-edge run scene:stranded-point --rules corrected .*--used-points .*'
[ -e stranded-point-mesh.obj ] && fail "copying the command saves"
enter; says mesh_dialog false
mv stranded-point-mesh.obj "$work/saved" || fail "nothing was saved"
sh -c "$(field copied)" 2>"$work/err.txt" || fail "the copied command fails: $(cat "$work/err.txt")"
cmp stranded-point-mesh.obj "$work/saved" || fail "the copied command writes another mesh"
ask_to_save
says typing true; press ctrl+a ctrl+v; says mesh_name 'spiraling-edge run scene:stranded-point .*'
press Escape; says mesh_dialog false
stop
well
