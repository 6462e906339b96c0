#!/usr/bin/env bash
# The mouse in the view: points, edges and triangles are picked, also by clicks that come within a frame.
. "$(dirname "$0")/harness.sh"
start scene:sphere
says phase ready
go_to 60
says pivot 60

# Around the pivot there are all three kinds of things.
press f
read -r x y < <(center "region view")
find_kind() {
    local dx dy
    for dy in 0 30 -30 60 -60 90 -90; do
        for dx in 0 18 36 54 72 -18 -36 -54 -72; do
            click $((x + dx)) $((y + dy))
            [ "$(field selection)" = "$1" ] && return 0
        done
    done
    fail "no $1 is found about the pivot"
}
find_kind point; denies selected null
find_kind triangle; says selected null; says selection_present true
points=$(field selection_points)
# The selection stays when stepping, and is not there before it was made.
press Home; says pivot 0; says selection triangle; says selection_present false
press ctrl+p; says palette true; type_text "selection was made"; press Return; says palette false
says selection_present true
[ "$(field selection_points)" = "$points" ] || fail "the selection changed"
go_to 60; press f; press Escape; says selection none
find_kind edge; says selection_present true
press Escape; says selection none

# A double click centers the orbit there, and keeps the selection; also if both presses come within
# one frame.
go_to p12; says selection point; says selected 12
press Return
read -r x y < <(center "region view")
camera=$(field camera)
undo=$(field undo)
move_to $((x + 40)) $((y + 30))
double_click() {
    kill -STOP "$program"
    xdotool click --repeat 2 --delay 60 1
    kill -CONT "$program"
}
act 4 double_click
leaves camera "$camera" # otherwise the center did not move
says selected 12
# It did not change between the two clicks either: undo has only the camera.
says undo "$((undo + 1))"
press ctrl+z; says message "Undone: camera\."; says selected 12
# A single click selects once no second one can come; at another position, so that it is not a third click.
click $((x - 40)) $((y - 30))
denies selected 12
press Escape

# A press right after a jump of the pointer, both within one frame, does not move the camera; nor
# does a press that is moved by less than a drag.
press Return
read -r x y < <(inside "region view" 5 45)
read -r far_x far_y < <(inside "region view" 95 45)
camera=$(field camera | sed 's/[][{}.*+?()|^$\\]/\\&/g')
for button in 1 2 3; do
    move_to "$x" "$y"
    kill -STOP "$program"
    xdotool mousemove --window "$window" "$far_x" "$far_y" mousedown "$button"
    kill -CONT "$program"
    xdotool mousemove_relative --sync -- 3 2
    xdotool mouseup "$button"
    says camera "$camera"
    press Escape
done
# A longer one orbits.
drag "$x" "$y" 60 20; denies camera "$camera"
stop
well
