#!/usr/bin/env bash
# Why and why not: W on the selection, moves to lines of the ledger, in both
# directions of time; the context menu; missing things by text; the query line and its
# list; bars of the charts.
. "$(dirname "$0")/harness.sh"
start scene:stranded-point
says phase ready
# Its failure is shown once it is found, with the paper's sentence.
says open_tab Paper
press w; says open_tab Ledger
# Without a selection the box has the keyboard.
type_text "point 32"; press Return
says selected 32; says asking false
says ledger '.*"answer": "Point 32 is not in the mesh.*"cause": "73.sort.8".*'
press Escape; press Escape; says selection none

# From a selected point.
go_to p32; says selected 32
press w; says open_tab Ledger; says asking false
# The answer goes to the clipboard.
click_on "ledger copy"; says notice "Copied the answer.*"
click_on "ledger cause"; says address 73.sort.8
press bracketleft; says address '[0-9.a-z]+'; leaves address 73.sort.8; says busy false
here=$(field address)
press bracketright; says address 73.sort.8
# A click on a line: back to it.
click_on "line $here"; says address "$here"

# An edge that is not in the mesh.
click_on "ledger box"; type_text "12,40"; press Return
says selection edge; says asking false; says ledger '.*"answer": "Edge 12-40 is not in the mesh.*'
click_on "ledger box"; type_text "12,4000"; press Return
says selection edge
press Escape; press Escape

# Right click: the menu; with a point selected it queries the edge of both.
go_to 60; says pivot 60; press Escape; press f
read -r x y < <(center "region view")
found=no
for dy in 0 20 -20 40 -40; do
    for dx in 0 20 40 -20 -40; do
        press Escape; says selection none
        click $((x + dx)) $((y + dy))
        [ "$(field selection)" = point ] && { found=yes; break 2; }
    done
done
[ $found = yes ] || fail "no point is found about the pivot"
first=$(field selected)
press w; says ledger ".*\"subject\": \"point $first\".*"; says asking false
press Escape; says selection none
click $((x + dx)) $((y + dy)) 3
click_on "menu why"; says ledger ".*\"subject\": \"point $first\".*"

# The cause of the ring at the cursor.
says selected "$first"; press Escape; says selection none
go_to 25; says pivot 25; press w; says open_tab Ledger
# The mistake is still there.
click_on "ledger box"; press ctrl+a; type_text "ring #1"; press Return
says ledger '.*"subject": "ring #1 at 25.*'; says asking false
press Escape

# The query line: a mistake starts no query; a list, a step, the next one and back.
press ctrl+f; says open_tab Query
type_text "stage=sphere refused dragons"; press Return
says query '.*"line": "".*'
click_on "query box"; press End
press BackSpace BackSpace BackSpace BackSpace BackSpace BackSpace BackSpace BackSpace; press Return
says query '.*"line": "stage=sphere refused".*'; says asking false
first=$(field first)
press Home; says pivot 0
press F3; says address "$first"
press F3; leaves address "$first"; says busy false; second=$(field address)
press shift+F3; says address "$first"
click_on "line $second"; says address "$second"

# A bar leads to a list.
press ctrl+p; type_text "charts"; press Return; says open_tab Charts; says asking false
click_on "bar refusals sphere"; says open_tab Query
says query '.*"line": "stage=sphere refused".*'; says asking false
press ctrl+p; type_text "charts"; press Return; says open_tab Charts
click_on "bar refusals sort"; says query '.*"line": "stage=sort refused".*'

# Closest decisions, and the points in their colors.
press ctrl+p; type_text "closest decisions"; press Return; says open_tab Query; says closest '[0-9]+'
press Home; says pivot 0; picture status
click_on "tint margin"; says point_tint margin; picture margin
[ "$(differing status margin)" -gt 500 ] || fail "the tint cannot be seen"
stop

# Another run: the answers of the last one are gone, and the selection is queried again.
start scene:stranded-point
says phase ready; go_to p32; press w; says ledger '.*"cause": "73.sort.8".*'
press ctrl+r; says pivot 0; says ledger '.*"subject": "".*'
stop
well
