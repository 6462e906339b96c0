#!/usr/bin/env bash
# The mouse in the view: orbit, pan, zoom, selection; a click in empty space clears.
. "$(dirname "$0")/harness.sh"
start scene:sphere --goto 40
says address "40\.advance\.1"

# The legend has what is in the picture, no more.
[ -n "$(field "legend pivot p")" ] && [ -n "$(field "legend UNUSED")" ] || fail "the legend lacks the pivot"
press Home; says pivot 0
for name in "pivot p" rejected DONE; do [ -z "$(field "legend $name")" ] || fail "the legend has $name"; done
[ -n "$(field "legend UNUSED")" ] || fail "the legend lacks UNUSED"
go_to 40; says address "40\.advance\.1"

escaped() { printf '%s' "$(field camera)" | sed 's/[][{}.*+?()|^$\\]/\\&/g'; }
read -r x y < <(inside "region view" 20 20)
before=$(escaped); drag "$x" "$y" 60 20; denies camera "$before"
before=$(escaped); drag "$x" "$y" 30 30 3; denies camera "$before"
before=$(escaped); drag "$x" "$y" 30 30 2; denies camera "$before"
before=$(escaped); click "$x" "$y" 4; denies camera "$before"
says address "40\.advance\.1"

# Frame pivot centers the pivot; a click there selects it, and stepping keeps it.
frame_pivot() { press ctrl+p; type_text "frame pivot"; press Return; }
press Return
frame_pivot
read -r x y < <(center "region view")
click "$x" "$y"
denies selected null
point=$(field selected)
press F10 F10
says pivot 42
says selected "$point"
# A drag selects nothing.
press Escape; says selected null
drag "$x" "$y" 90 40
says selected null
# Beside the surface there is nothing to select.
press Return
read -r x y < <(inside "region view" 3 6)
click "$x" "$y"
says selected null
# A neighbor of the pivot is highlighted under the pointer.
frame_pivot
read -r x y < <(center "region view")
lit() {
    local dx dy
    for dy in 0 25 -25 50 -50 75 -75 100 -100; do
        for dx in 25 40 55 70 85 100 120 140 160 180 200 220; do
            move_to $((x + dx)) $((y + dy))
            [ "$(field hovered)" != null ] && return 0
        done
    done
    return 1
}
lit || fail "no neighbor of the pivot lights up"
# A press right after a jump of the pointer, both within one frame, does not move the camera; nor
# does a press that is moved by less than a drag.
press Return
read -r x y < <(inside "region view" 5 5)
read -r far_x far_y < <(inside "region view" 95 95)
camera=$(escaped)
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
# A click on an end of an axis looks from there.
press Return
click_on "axis z"; says camera '.*"pitch": 90(\.0)?[,}].*'
click_on "axis z"
click_on "axis y"; denies camera '.*"pitch": 90(\.0)?[,}].*'
# What is kept from step to step is what would be drawn.
press Return; go_to 60; says moving false; picture direct
press F10 F10 F10 shift+F10 shift+F10 shift+F10; says address "60\.advance\.1"
says moving false; picture stepped
[ "$(differing direct stepped)" -eq 0 ] || fail "a step forth and back changes the picture"
press F10 F10; says address "62\.advance\.1"; says moving false; picture stepped
press 5 5; says moving false; picture direct
[ "$(differing direct stepped)" -eq 0 ] || fail "steps leave a picture that differs from a new one"
stop
well
