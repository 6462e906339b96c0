#!/usr/bin/env bash
# Two runs side by side: chosen by a click, the first difference and the regions on their keys, one
# timeline, a swap, a session that keeps the comparison, and a mesh from a file.
. "$(dirname "$0")/harness.sh"
start scene:torus
says phase ready
press d; says notice "No comparison.*"
press ctrl+d; says layout compare
click_on "compare usual"
says compare_done true
says difference_a "7\.sphere\.1"; says difference_b "7\.sphere\.3"
denies only_a 0
# One timeline: equal up to the difference, both at their ends at last.
go_to 5.sort.3; says address "5\.sort\.3"; says other_address "5\.sort\.3"
press Right; says address "5\.sort\.4"; says other_address "5\.sort\.4"
press End; denies address "5\.sort\.4"; denies other_address "5\.sort\.4"
end=$(field other_address)
camera=$(field camera)
press d; says address "7\.sphere\.1"; says other_address "7\.sphere\.3"
leaves camera "$camera"  # the pivot is framed
press Right; denies address "7\.sphere\.1"; says other_address "7\.sphere\.[0-9]+"
# Regions, in the finished meshes.
press shift+d; says region 1; says other_address "$end"
press shift+d; says region 2
press ctrl+shift+d; says region 1
click_on "compare region 2"; says region 2
# A click in the other view selects in both; a drag there turns both.
press Return
camera=$(field camera)
read -r x y < <(inside "region other view" 50 50)
drag "$x" "$y" 80 20 1
leaves camera "$camera"
# It is kept.
press ctrl+s; says file_browser true
type_text "$work/kept"; press Return; says file_browser false
grep -q '"compare"' "$work/kept.sesession" || fail "the session forgets the comparison"
# After a swap the first run is beside the other.
click_on "compare swap"
says phase ready; says compare_done true; says other_rules paper
says difference_a "7\.sphere\.3"; says difference_b "7\.sphere\.1"
click_on "compare stop"; says compare_with null
press ctrl+d; says layout debug
stop
start "$work/kept.sesession"
says layout compare; says compare_done true; says other_rules robust
stop
# Also from a scene that opens at its failure.
start scene:four-edge-hole --layout compare --with "--rules robust" --goto difference
says compare_done true
says address "$(field difference_a)"; says other_address "$(field difference_b)"
stop
# The form: a number of the paper's rules, another input, a what-if; and the choice of B again.
start scene:torus --layout compare
says phase ready
click_on "compare part Rules"; click_on "compare rules filter"; type_text "maxgap"
click_on "compare rule maxgap"; press ctrl+a; type_text "100"; press Return
click_on "compare part Rules"
click_on "compare part Input"
click_on "compare prepare count"; press ctrl+a; type_text "16"
click_on "compare prepare Symmetric"
click_on "compare part Input"
click_on "compare part What if"
click_on "compare what if line"; type_text "60.advance pivot 9999"; press Return
click_on "compare what if 1"
click_on "compare begin"
says compare_done true
says compare_other "robust rules, maxgap 100, 16 neighbors, symmetric lists"
# The first difference has a mark on the strip; a click there has the effect of its key.
press d; difference=$(field address); beside=$(field other_address)
press End; leaves address "$difference"
click_on "strip difference"; says address "$difference"; says other_address "$beside"
# A right click in the other view queries both runs.
go_to 300.sphere.1; says address "300\.sphere\.1"; press f; says moving false
read -r x y < <(inside "region other view" 50 50)
click "$x" "$y" 3
click_on "menu why"
says compare_why "(point|edge|triangle) .*"; says compare_why_other ".*[0-9]+\..*"
place=$(field address)
click_on "compare cause"; leaves address "$place"
click_on "compare why close"; says compare_done true
click_on "compare other"; click_on "compare back"; says compare_done true
# Panels are in another layout.
press ctrl+p; type_text "rules"; press Return; says layout debug; says open_tab Rules; says choices '\[\]'
stop
# A fork beside the run without what-ifs, by one click.
size=1600x980 start scene:torus --goto 60.emit.1
says address "60\.emit\.1"
press ctrl+p; type_text "what if forks"; press Return; says open_tab "What if"
click_on "what if here"; says what_if '\[ "60\.guard drop [0-9]+" \]'; says phase ready
press ctrl+d; says layout compare
click_on "compare true run"
says compare_done true; says compare_other "no what-ifs"
stop
# A mesh of another program; also in a small window with large text.
"$viewer" scene:torus --with "$work/nothing.ply" --screenshot "$work/none.png" >/dev/null 2>&1 &&
    fail "a mesh that is not there is no error"
printf 'OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n' >"$work/other.off"
scale=2 size=1024x640 start scene:torus --layout compare --with "$work/other.off"
says compare_done true; says compare_with mesh; says only_b 1
press d; says address "1\.emit\.1"
# It has no decisions, which a message reports.
read -r x y < <(inside "region other view" 50 50)
click "$x" "$y" 3
[ -n "$(field "menu beside")" ] || fail "a right click on the mesh of a file says nothing"
press Escape
stop
well
