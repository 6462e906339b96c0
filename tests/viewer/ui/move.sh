#!/usr/bin/env bash
# A point is dragged in the view while the panel What if is open: its pivot follows, Esc takes it
# back, and the release makes a what-if.
. "$(dirname "$0")/harness.sh"
start scene:torus --goto 60.sphere.1
says address '60\.sphere\.1'
press f; says settled true
read -r x y < <(center "region view")

# A press on the pivot, which is in the middle, turns the view as long as the panel is closed.
camera=$(field camera)
drag "$x" "$y" 40 0
leaves camera "$camera"; says dragged null
camera_is_back() { [ "$(field camera)" = "$camera" ]; }
press ctrl+z; poll camera_is_back || fail "the camera is not back"

click_on "tab What if"
says dragged null
press f; says settled true
camera=$(field camera)
read -r x y < <(center "region view")
# The point under test, by the mark of the point under the pointer.
find_tested() {
    local dx dy
    for dy in 0 12 24 36 -12 -24; do
        for dx in 0 -12 -24 -36 -48 -60 -72 12 24 36 48; do
            move_to $((x + dx)) $((y + dy))
            [ "$(field hovered)" = "$1" ] && { x=$((x + dx)); y=$((y + dy)); return 0; }
        done
    done
    fail "point $1 is not found"
}
find_tested 414
camera=$(field camera)
decision=$(field decision)
# Held, the point is drawn where the pointer is, and the decisions of its pivot are made again.
hold() {
    move_to "$x" "$y"
    act 1 xdotool mousedown 1
    act 1 xdotool mousemove_relative -- "$(($1 / 2))" "$(($2 / 2))"
    act 1 xdotool mousemove_relative -- "$(($1 - $1 / 2))" "$(($2 - $2 / 2))"
}
let_go() { act 1 xdotool mouseup 1; }
hold 60 20
says dragged 414
leaves decision "$decision"
[ "$(field camera)" = "$camera" ] || fail "the drag of a point turns the view"
says selected 414
# Esc takes it back, while the button is still down.
# Without --clearmodifiers, which would lift the button first.
act 2 xdotool key Escape
says dragged null
[ "$(field decision)" = "$decision" ] || fail "the decision is not as before"
let_go
says what_if '\[\]'; [ "$(field camera)" = "$camera" ] || fail "the rest of the drag turns the view"

# Released it is a what-if at the pivot of the cursor, and undone it is none.
hold 60 20
says dragged "414"
let_go
says dragged null; says phase ready
says what_if ".*60 move 414 .*"
says address '60\..*'
press ctrl+z
says what_if '\[\]'
# A click is still a click.
click "$x" "$y"
says selected "414"; says what_if '\[\]'
