#!/usr/bin/env bash
# Present shows the address, and in every layout an arrow leads to a pivot outside of the view. The
# camera stays unless the decision is followed.
. "$(dirname "$0")/harness.sh"
start scene:sphere --goto 40.sort.1 --layout present
says layout present
says address_line "40\.sort\.1 · 6\.1"
says pivot_arrow false
press F11
says address_line "40\.sort\.2 · 6\.1"
go_to 40.sphere.1
says address_line "40\.sphere\.1 · 6\.3"

escaped() { printf '%s' "$(field camera)" | sed 's/[][{}.*+?()|^$\\]/\\&/g'; }
# The pivot is moved out of the view: the arrow appears, and stays during stepping.
away() {
    local x y
    read -r x y < <(inside "region view" 70 30)
    for _ in 1 2 3 4 5; do drag "$x" "$y" -500 60 3; done
    says pivot_arrow true
}
press f
says pivot_arrow false
# Present follows the decision, until that is turned off.
press shift+v
says follow false
away
camera=$(escaped)
press F11 F11 F10
says pivot 41
says camera "$camera"
says pivot_arrow true
# It is within the view, and a click on it frames the pivot.
read -r x y w h < <(field "pivot arrow" | tr -d '[],')
read -r vx vy vw vh < <(field "region view" | tr -d '[],')
{ [ "$x" -ge "$vx" ] && [ "$y" -ge "$vy" ] && [ $((x + w)) -le $((vx + vw)) ] &&
    [ $((y + h)) -le $((vy + vh)) ]; } || fail "the arrow is not within the view"
click_on "pivot arrow"
says pivot_arrow false
denies camera "$camera"
says selected null

# What a remote control sends: steps, a black or a white screen, the start. A key shows the window
# again, and does nothing else.
go_to 40.sort.1
press Next; says address "40\.sort\.2"
press Prior; says address "40\.sort\.1"
for key in b period w; do
    press "$key"; says blank true; says layout present; denies loop '.*"to": "40.*'
    press Next; says blank false; says address "40\.sort\.1"
done
# The spotlight dims what is not about the pivot.
move_to 20 20; picture plain
press l; picture spot
[ "$(differing plain spot 2%)" -gt 20000 ] || fail "the spotlight dims nothing"
press l; picture after
[ "$(differing plain after 2%)" -lt 200 ] || fail "the spotlight stays"
press b; says blank true
press Escape; says blank false; says layout present
press shift+F5; says layout present; says address "40\.sort\.1"
press F5; says pivot 0
go_to 40.sphere.1

# The other layouts have the address in the status bar, and the same arrow.
for layout in debug learn; do
    press F2
    says layout "$layout"
    says address_line ""
    away
    click_on "pivot arrow"
    says pivot_arrow false
done
stop

# At the start there is neither a pivot nor a section.
scale=2 size=1024x640 start scene:sphere --goto 0 --layout present
says address_line "start"
says pivot_arrow false
stop
well
