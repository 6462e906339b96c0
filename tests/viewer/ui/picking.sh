#!/usr/bin/env bash
# Points, edges and triangles picked in the view; playing by units and in a loop; mesh styles.
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
[ "$(wc -w <<<"$points")" -ge 3 ] || fail "a triangle has $points"
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

# One step of the unit forward and back.
go_to 20; says pivot 20
while [ "$(field unit)" != pivot ]; do press u; done
press o; says pivot 21
press shift+o; says pivot 20
press u; says unit event
press shift+o; says address '1\.seed.*'
press u; says unit sub-step
go_to 20; press u; says unit pivot

# Playing loops between its two marks.
press a; says loop '.*"from": "20[^"]*".*'
press period period period b; says loop '.*"to": "23[^"]*".*'
press End; says pivot '[0-9]{3,}'
for _ in 1 2 3 4; do press equal; done
press space; says playing true
for _ in $(seq 20); do
    sleep 0.1
    pivot=$(field pivot)
    [ "$pivot" -ge 20 ] && [ "$pivot" -le 23 ] || [ "$pivot" -gt 100 ] || fail "playing left the loop: $pivot"
done
says playing true
press space; says playing false
[ "$(field pivot)" -le 23 ] || fail "playing did not turn back"
press shift+a; says loop '.*"from": null.*'

# Mesh styles.
press End
says mesh_style faults
press m; says mesh_style flat
picture flat
for style in shaded wire birth component faults; do
    press m; says mesh_style "$style"
    picture "$style"
    # The mesh is sound.
    [ "$style" = faults ] || [ "$(differing flat "$style")" -gt 500 ] || fail "$style looks like flat"
done
stop
well
