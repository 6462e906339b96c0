#!/usr/bin/env bash
# By keyboard alone: Tab through the panels, arrows along rows, Enter, and Esc one thing at a time.
. "$(dirname "$0")/harness.sh"
start scene:torus --goto 137.sphere.3
says address "137\.sphere\.3"; says keyboard view
# A press that comes in the same frame as the Enter before it is lost to the lists.
walk() {
    local chord
    for chord in "$@"; do press "$chord"; done
}

# The whole cycle, forward and back; Ctrl+Tab is the same.
for stop in steps rings "ring points" tabs content "find tabs" "change tabs" view; do press Tab; says keyboard "$stop"; done
press ctrl+Tab; says keyboard steps
press shift+Tab; says keyboard view
press shift+Tab; says keyboard "change tabs"
press Escape; says keyboard view

# Steps: from the row of the cursor on; Enter goes there and stays in the list.
press Tab; says keyboard steps
walk Down Return; says address "137\.sphere\.4"; says keyboard steps
walk Up Up Return; says address "137\.sphere\.2"
# Plain keys belong to the list, function keys and chords do not.
press n; denies layers '.*"normals".*'; says address "137\.sphere\.2"
press F10; says pivot 138
press shift+F10; says pivot 137

# Rings: Enter highlights one. Its points: Left and Right move, Enter selects.
press Escape; says keyboard view
press Tab Tab; says keyboard rings; says highlighted_ring null
press Return; says highlighted_ring 0
press Tab; says keyboard "ring points"; walk Right Return; denies selected null
# Tabs: Enter opens; arrows scroll its content.
press Tab; says keyboard tabs; says open_tab Inspect
walk Right Return; says open_tab Paper
walk Left Return; says open_tab Inspect
press Tab; says keyboard content; picture before
walk Down Down Down Down; picture after
[ "$(differing before after)" -gt 200 ] || fail "arrows do not scroll Inspect"

# Esc closes one thing at a time: a list, the panel, the selection, the layout; it never quits.
selected=$(field selected)
press F1; says cheat_sheet true
press Escape; says cheat_sheet false; says selected "$selected"
press Tab; press Escape; says keyboard view; says selected "$selected"
press F2 F2; says layout present
press Escape; says selected null; says layout present
press Tab; says keyboard view
press Escape; says layout debug
press Escape Escape; says phase ready
kill -0 "$program" 2>/dev/null || fail "Esc quits"

# Find and Change are a line each until a tab is opened.
for stop in steps rings "ring points" tabs content "find tabs"; do press Tab; says keyboard "$stop"; done
walk Right Return; says open_tab Ledger
press Tab; says keyboard find; press Tab; says keyboard "change tabs"; press Tab; says keyboard view

# In a narrow window, where all panels are tabs, too.
resize 640 640
click_on "group Steps"; says open_tab Steps; says keyboard view
press Tab; says keyboard steps
walk Down Return; denies address "137\.advance\.1"
stop
well
