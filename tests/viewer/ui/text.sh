#!/usr/bin/env bash
# Chords that end within one frame reach text fields and the go-to box.
. "$(dirname "$0")/harness.sh"
# A chord as made by a fast user or a program; xdotool releases Ctrl first.
quick() {
    local chord
    for chord in "$@"; do xdotool key --clearmodifiers --delay "${delay:-12}" "$chord"; done
}
start scene:torus --goto 137.sphere.3
says address "137\.sphere\.3"

# The line above the list of steps, from the clipboard.
press ctrl+p; type_text "steps"; press Return; says part Steps
read -r x y < <(center "steps filter")
for delay in 12 2 0; do
    click "$x" "$y"
    quick ctrl+a BackSpace; says filter ""
    type_text "split"; says filter split
    quick ctrl+a ctrl+c ctrl+x; says filter ""
    quick ctrl+v ctrl+v; says filter splitsplit
    quick ctrl+a ctrl+v; says filter split
    # Text typed right after a chord replaces what it selected.
    quick ctrl+a; xdotool type --delay "$delay" join; says filter join
    # In the other order: text is inserted before it is selected.
    xdotool type --delay "$delay" y; quick ctrl+a ctrl+x; says filter ""
    # Keys that move: one after the other, none lost.
    xdotool type --delay "$delay" ac; quick Left; xdotool type --delay "$delay" b
    quick Home Delete End BackSpace; says filter b
    press Escape
done

# The go-to box: an address, and a position copied by Ctrl+C.
click_on "region view"
press Escape Home; says pivot 0
press ctrl+g; type_text "12.sort.2"
quick ctrl+a ctrl+c ctrl+a ctrl+v Return; says address "12\.sort\.2"
press ctrl+c; press Home; says pivot 0
quick ctrl+g ctrl+v Return; says address "12\.sort\.2"
press ctrl+g; type_text "4."; quick ctrl+a; xdotool type --delay 0 "3.0"; quick Left Left Left
xdotool type --delay 0 "1"; quick End BackSpace BackSpace Return
says address "13\.advance\.1"
# Before a letter, chords of a text field are not those of the view.
press ctrl+b; says bookmarks '.*13.*'
press ctrl+g; quick ctrl+z; press Escape; denies bookmarks '\[\]'
press ctrl+b; says bookmarks '\[\]'

# Text typed right after a command that opens a text field goes there, even if a frame
# is slow: nothing of it reaches the view.
at_once() { # CHORD TEXT: all of it waits when the next frame begins
    kill -STOP "$program"
    xdotool key --clearmodifiers --delay 0 "$1" type --delay 0 -- "$2"
    kill -CONT "$program"
}
press Escape Escape; says selected null
click_on "region view"
theme=$(field theme); pins=$(field pins); style=$(field mesh_style); address=$(field address)
at_once ctrl+f "stage=sphere kept"; says query_typed "stage=sphere kept"
press Return; says found "[1-9][0-9]*"
press Escape; says keyboard view
at_once w "812,640"; says ledger_typed "812,640"
press Escape; says keyboard view
at_once ctrl+p "next pivot"; says palette_typed "next pivot"
press Escape; says palette false
at_once ctrl+k "mesh"; says palette_typed "mesh"
press Escape; says palette false
at_once ctrl+g "15.sort.2"; press Return; says address "15\.sort\.2"
[ "$theme $pins $style" = "$(field theme) $(field pins) $(field mesh_style)" ] ||
    fail "keys that were typed reached the view: $(field theme) $(field pins) $(field mesh_style)"
printf '%s\n' "0 0 0 0 0 1" "1 0 0 0 0 1" "0 1 0 0 0 1" "1 1 0 0 0 1" >"$work/typed.xyz"
at_once ctrl+o "$work/typed.xyz"; says file_browser true; says typing true
press Return; says input ".*typed\.xyz"; says file_browser false
stop
well
