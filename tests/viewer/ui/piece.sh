#!/usr/bin/env bash
# A piece of the scan: a box or a lasso around points, kept or left out; points that are not in the run.
. "$(dirname "$0")/harness.sh"
cli=$(dirname "$viewer")/spiraling-edge
[ -x "$cli" ] || { echo "skipped: no spiraling-edge beside the viewer"; exit 77; }
"$cli" run scene:sphere -q -o "$work/sphere.obj" || fail "no points"
awk '$1 == "v" { v[++n] = $2 " " $3 " " $4 } $1 == "vn" { print v[++m], $2, $3, $4 }' "$work/sphere.obj" >"$work/sphere.xyz"
all=$(wc -l <"$work/sphere.xyz")

start "$work/sphere.xyz"
says phase ready; says points "$all"; says aside '\{\}'; says doctor done
# Found by its words; the strip says what to do.
press ctrl+p; type_text "lasso"; press Return
says piece_tool true; says piece_inside 0
camera=$(field camera)
read -r x y < <(center "region view")
# Below the plate of the tool.
drag $((x + 60)) $((y - 80)) 190 230
leaves piece_inside 0
[ "$(field camera)" = "$camera" ] || fail "a box turns the view"
inside=$(field piece_inside)
says marked "$inside"
[ "$inside" -lt "$all" ] || fail "all $inside points are inside"
# The view can be turned: Ctrl with a drag. The points stay marked.
act 1 xdotool keydown Control_L
drag "$x" "$y" 30 0
act 1 xdotool keyup Control_L
leaves camera "$camera"; says piece_inside "$inside"; says breakpoints '\[\]'
# Esc ends the tool; its key begins it again, empty.
press Escape; says piece_tool false; says marked 0
press x; says piece_tool true; says piece_inside 0
# With nothing inside nothing is run.
press Delete; says notice "No points are inside.*"; says points "$all"

# Left out: the run ends with the rest, and the camera stays.
# Below the plate of the tool.
drag $((x + 60)) $((y - 80)) 190 230
leaves piece_inside 0
inside=$(field piece_inside)
camera=$(field camera)
press Delete
says points $((all - inside)); says phase ready; says at_end true; says piece_tool false
says aside ".*\"left_out\": $inside.*"
[ "$(field camera)" = "$camera" ] || fail "the camera moved"
says message "Left out: .*"
# Ctrl+Z brings them back, Ctrl+Y leaves them out again.
press ctrl+z; says points "$all"; says aside '\{\}'; says at_end true
press ctrl+y; says points $((all - inside)); says aside ".*left_out.*"

# The mesh has the indices of the file, and no command line makes it.
press ctrl+p; type_text "copy command"; press Return
says message "There is no command for points left out.*"
press ctrl+e; says mesh_dialog true
press ctrl+a; type_text "$work/rest.ply"; press Return; says mesh_dialog false
head -c 1000 "$work/rest.ply" | grep -aq "property uint index" || fail "the mesh has no indices"
head -c 1000 "$work/rest.ply" | grep -aq "element vertex $((all - inside))" || fail "the mesh has other points"

# A session keeps them left out.
press ctrl+s; says file_browser true; type_text "$work/kept"; press Return; says file_browser false
grep -q '"left_out": "' "$work/kept.sesession" || fail "the session forgets the points"
stop
start "$work/kept.sesession"
says phase ready; says points $((all - inside)); says aside ".*\"left_out\": $inside.*"
# Brought back by a click in the panel Doctor.
press ctrl+p; type_text "doctor"; press Return; says open_tab Doctor
click_on "show left_out"; says moving false
click_on "return left_out"; says points "$all"; says aside '\{\}'

# A line, by its button: kept alone.
press x; says piece_tool true
press ctrl+shift+j; click_on "piece lasso"
read -r x y < <(center "region view")
move_to $((x - 60)) $((y - 60))
act 1 xdotool mousedown 1
for by in "120 0" "0 120" "-120 0"; do act 1 xdotool mousemove_relative -- $by; done
act 1 xdotool mouseup 1
leaves piece_inside 0
inside=$(field piece_inside)
click_on "piece keep"
says points "$inside"; says piece_tool false; says at_end true
says aside ".*\"left_out\": $((all - inside)).*"
stop

# Points set aside for noise are counted, can be seen, and come back by a click; Ctrl+Z sets them aside again.
awk 'BEGIN { srand(5); for (i = 0; i < 1500; ++i) { z = 1 - (2 * i + 1) / 1500; r = sqrt(1 - z * z); a = i * 2.39996323
         h = 1 + 0.18 * (rand() + rand() + rand() - 1.5); print h * r * cos(a), h * r * sin(a), h * z, r * cos(a), r * sin(a), z } }' >"$work/noisy.xyz"
start "$work/noisy.xyz" --rules robust
says phase ready; says doctor done; says alert_search done
says aside '\{ "noise": [0-9]+ \}'
press ctrl+p; type_text "doctor"; press Return; says open_tab Doctor
says moving false; picture marks
click_on "tab Layers"
click_on "layer aside"; says pins '.*"aside": "off".*'
says moving false; picture none
[ "$(differing marks none)" -gt 100 ] || fail "points set aside cannot be seen"
click_on "layer aside"
click_on "tab Doctor"; click_on "return noise"
says aside '\{\}'; says choices '\[ "noise=off" \]'
press ctrl+z; says aside '\{ "noise": [0-9]+ \}'
stop
# The options of the command line choose a piece as well, which sessions keep.
"$cli" run "$work/sphere.xyz" --crop=-9,-9,0,9,9,9 --thin 0.1 -q --report "$work/piece.json" || fail "no piece"
kept=$(sed -n 's/^  "points": \([0-9]*\),/\1/p' "$work/piece.json")
[ "$kept" -gt 0 ] && [ "$kept" -lt "$all" ] || fail "$kept of $all points are in the piece"
start "$work/sphere.xyz" --crop=-9,-9,0,9,9,9 --thin 0.1
says phase ready; says points "$kept"
press ctrl+s; says file_browser true
type_text "$work/cut"; press Return; says file_browser false
stop
start "$work/cut.sesession"; says phase ready; says points "$kept"
stop
well
