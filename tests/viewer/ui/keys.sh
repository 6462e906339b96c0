#!/usr/bin/env bash
# Keys of every kind, held keys, playing by the clock, the clipboard and the whole screen. What each key of the
# table does is tested without a window.
. "$(dirname "$0")/harness.sh"
start scene:sphere
says phase ready
says pivot 0

# Function keys, signs, arrows, the keys beside them, with and without modifiers.
press F10; says address "1\.advance\.1"
press period; says address "2\.advance\.1"
press comma; says address "1\.advance\.1"
press shift+F10; says pivot 0
go_to 20; says address "20\.advance\.1"
press Right; says pivot 21
press Left; says address "20\.advance\.1"
press End; says pivot "[1-9][0-9][0-9]+"
whole=$(field pivot)
press Home; says pivot 0
press F5; says pivot "$whole"
press shift+F5; says pivot 0
press ctrl+Right; says address "1\.seed\.1"
go_to 12.sort.2; says address "12\.sort\.2"
go_to 40.sphere.2; says address "40\.sphere\.2"
press alt+Left; says address "12\.sort\.2"
press alt+Right; says address "40\.sphere\.2"
for chord in 7 shift+f; do
    before=$(field camera)
    press "$chord"; leaves camera "$before"
done
rate=$(field rate)
press equal; denies rate "$rate"
press minus; says rate "$rate"
press n; says pins '.*"normals": "on".*'
press n; says pins '\{\}'
press F1; says cheat_sheet true; press Escape; says cheat_sheet false
press question; says cheat_sheet true; press Escape; says cheat_sheet false

# The clipboard: a position in the view and in the go-to box.
go_to 40.sphere.2; says address "40\.sphere\.2"
press ctrl+c
press Home; says pivot 0
press ctrl+v; says address "40\.sphere\.2"
press Home; says pivot 0
press ctrl+g; press ctrl+v; press Return; says address "40\.sphere\.2"

# Ten bookmarks have a key. A notice disappears by itself.
for pivot in 41 42 43 44 45 46 47 48 49 50; do go_to $pivot; says pivot $pivot; press ctrl+b; done
says notice "Bookmark set: .*"; says notice ""
for number in 1 2 3 4 5 6 7 8 9; do press ctrl+$number; says pivot $((40 + number)); done
press ctrl+0; says pivot 50

# A loop plays its range repeatedly, and only that.
go_to 12.sort.2; says address "12\.sort\.2"
press a; go_to 14; says address "14\.advance\.1"
press b
press space; says playing true
says pivot 14; says pivot 12; says pivot 14
press space; says playing false
[[ $(field pivot) =~ ^1[234]$ ]] || fail "the loop is left: pivot $(field pivot)"
press shift+a

# While the back-quote is held, the state before the decision is shown.
go_to 30.emit.1; says address '30\.emit\.1'
triangles=$(field triangles)
xdotool keydown grave; says before true; says triangles "$((triangles - 1))"
xdotool keyup grave; says before false; says triangles "$triangles"
# With Shift the two states alternate, the window redraws by itself, and no trace is left.
xdotool keydown shift keydown grave
says blinking true
for state_shown in before after before after; do says shown_state $state_shown; done
xdotool keyup grave keyup shift; says blinking false; says shown_state after
xdotool keydown grave; says shown_state before
xdotool keydown shift; says blinking true; says shown_state after; says shown_state before
xdotool keyup shift; says blinking false; says shown_state before
xdotool keyup grave; says shown_state after
# A new fan moves for a moment, then the window rests.
motions=$(field motions)
press Right; says address '30\.emit\.2'; says motions $((motions + 1)); says moving false

# Reloading asks for the bookmarks; discarded, they are gone, and nothing is asked again.
press ctrl+r; says asks true; click_on "leave discard"; says asks false
says bookmarks '\[\]'; says phase ready; says pivot 0
press ctrl+r; denies asks true; says phase ready
width() { xdotool getwindowgeometry --shell "$window" | sed -n 's/^WIDTH=//p'; }
wider_than() { [ "$(width)" -gt "$1" ]; }
press alt+Return
poll wider_than 1280 || fail "Alt+Enter does not fill the screen: $(width)"
press alt+Return
poll is_wide 1280 || fail "Alt+Enter does not go back: $(width)"
press F12; says notice "Saved .*"
ls "$HOME"/spiraling-edge-*.png >/dev/null 2>&1 || fail "F12 saves no picture"

# A click beside the line of a dialog returns the focus to it.
press ctrl+o; says file_browser true
click 900 620; type_text "scene:torus"; press Return; says input scene:torus
stop
well
