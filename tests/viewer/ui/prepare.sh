#!/usr/bin/env bash
# Preparing in another way: neighbors, normals and walls derived as requested, marked, kept in a session.
. "$(dirname "$0")/harness.sh"
cli=$(dirname "$viewer")/spiraling-edge
[ -x "$cli" ] || { echo "skipped: no spiraling-edge beside the viewer"; exit 77; }
{ "$cli" run scene:sphere -q -o "$work/sphere.obj" &&
    awk '$1 == "v" { v[++n] = $2 " " $3 " " $4 } $1 == "vn" { s = ++m % 9 ? 1 : -1; print v[m], s * $2, s * $3, s * $4 }' \
        "$work/sphere.obj" >"$work/flipped.xyz"; } || fail "no points with flipped normals"
# keeps TEXT: saved, the session has it; at once, or when the input has been prepared again.
keeps() {
    for _ in $(seq 20); do
        press ctrl+s
        grep -qF "$1" "$work/kept.sesession" && return 0
    done
    fail "the session forgets $1"
}
# reach NAME: scrolls the form until the item can be clicked, and clicks it.
reach() {
    local x y h top end y2
    read -r x y < <(inside "region change" 50 40); move_to "$x" "$y"
    for _ in $(seq 30); do
        read -r _ top _ end < <(field "region change" | tr -d '[],')
        read -r _ y2 _ h < <(field "$1" | tr -d '[],')
        [ -n "${h:-}" ] && [ "$y2" -gt $((top + 40)) ] && [ $((y2 + h)) -lt $((top + end - 40)) ] && { click_on "$1"; return; }
        [ -n "${h:-}" ] && [ "$y2" -le $((top + 40)) ] && act 1 xdotool click 4 || act 1 xdotool click 5
    done
    fail "$1 does not come into sight"
}
start sample:plane,n=400
says phase ready; says points 400
says derived '\[ "neighbors" \]'
go_to p12; says selected 12
press F1; says cheat_sheet true; press Escape
press ctrl+shift+r; says prepare true; says typing true
type_text "0"; press Return; says prepare true
read -r x y < <(inside "prepare count" 50 50); click "$x" "$y"; type_text "9"
reach "prepare Derived from the positions"; reach "prepare The box around all points"; click_on "prepare ok"
says prepare false; says phase ready; says pivot 0; says selected 12
says derived '\[ "neighbors", "normals", "types" \]'
# It is kept, and Esc changes nothing.
press ctrl+s; says file_browser true
type_text "$work/kept"; press Return; says file_browser false
grep -q '"normals": "derived"' "$work/kept.sesession" || fail "the session forgets the normals"
grep -q '"box": "auto"' "$work/kept.sesession" || fail "the session forgets the box"
grep -q '"neighbors": 9' "$work/kept.sesession" || fail "the session forgets the neighbors"
press ctrl+shift+r; says prepare true; press Escape Escape; says prepare false; says selected 12
stop
start "$work/kept.sesession"; says phase ready
says derived '\[ "neighbors", "normals", "types" \]'
# By keyboard alone: the first field has it, Enter prepares; earlier choices stay.
press ctrl+shift+r; says prepare true; says typing true
type_text "7"; press Return; says prepare false; says phase ready
keeps '"neighbors": 7'
grep -q '"box": "auto"' "$work/kept.sesession" || fail "what was chosen before is gone"
# Down from there, the next kind of list; in units of the spacing.
press ctrl+shift+r; says prepare true
reach "prepare spacings"; type_text "1.5"; press Return; says prepare false
keeps '"reach": 1.5'
# Normals that face a scanner are flipped ones; it takes three numbers.
press ctrl+shift+r; says prepare true
reach "prepare From the input##m"; reach "prepare scanner"; type_text "0"; press Return; says prepare true
reach "prepare scanner"
read -r x y < <(inside "prepare scanner" 16 50); click "$x" "$y"; type_text "5"
read -r x y < <(inside "prepare scanner" 84 50); click "$x" "$y"; type_text "-3"; press Return
says prepare false; says phase ready
keeps '"scanner": ['
grep -q '"normals": "oriented"' "$work/kept.sesession" || fail "a scanner turns no normals"
stop
start "$work/kept.sesession"; says phase ready
keeps '"scanner": ['
stop
start sample:plane,n=400 --orient -k 8 --symmetric --box=-1,-1,-1,1,1,1
says derived '\[ "neighbors", "orientation", "types" \]'
stop
# A choice takes precedence over the doctor's fix, and the form shows it.
start "$work/flipped.xyz"; says phase ready; says doctor done
click_on "tab Doctor"; click_on "doctor fix all"; says cures '\[ "flipped_normals" \]'; says phase ready
press ctrl+shift+r; says prepare true
reach "prepare From the input##m"; click_on "prepare ok"; says prepare false; says cures '\[\]'
stop
# The pointer does not move for a number of frames.
LD_PRELOAD=$offscreen timeout 600 "$viewer" scene:sphere --no-config --frames 30 || fail "--frames does not end"
well
