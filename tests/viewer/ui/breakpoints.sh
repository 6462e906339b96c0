#!/usr/bin/env bash
# Breakpoints and watches: F9, F5, Shift+F5, the panel, a lasso, undo, and the session file.
. "$(dirname "$0")/harness.sh"
start scene:figure-12 --goto 0
says phase ready
says pivot 0

# F9 at a split: F5 and Shift+F5 stop at the splits, and nowhere else.
go_to 35.split.1; says address "35\.split\.1"
press F9
says breakpoints '\[ "stage=split" \]'
leaves breakpoint_hits "[ null ]"
total=$(field breakpoint_hits | tr -dc 0-9)
[ "$total" -gt 1 ] || fail "the tube splits more than once: $total"
press Home; says pivot 0
forward=
for _ in $(seq "$total"); do
    before=$(field address)
    press F5; leaves address "$before"
    [[ $(field address) =~ split ]] || fail "F5 stops at $(field address)"
    forward="$forward $(field address)"
done
press F5; leaves address "${forward##* }"
denies address ".*split.*"
end=$(field pivot)
backward=
for _ in $(seq "$total"); do
    before=$(field address)
    press shift+F5; leaves address "$before"
    backward=" $(field address)$backward"
done
[ "$forward" = "$backward" ] || fail "forward:$forward, back:$backward"
press shift+F5; says pivot 0

# Playing pauses there.
press u; says unit event; press space; says address "35\.split\.1"; says playing false

# A breakpoint on a point, and its removal; undo restores it.
go_to p40; says selected 40
press F9; says breakpoints '\[ "stage=split", "point=40" \]'
press F9; says breakpoints '\[ "stage=split" \]'
press ctrl+z; says breakpoints '\[ "stage=split", "point=40" \]'
press ctrl+y; says breakpoints '\[ "stage=split" \]'
press Escape; says selected null

# The panel: a line is edited in place.
press ctrl+p; type_text "breakpoints"; press Return
says open_tab Breakpoints
click_on "breakpoint 1"
press ctrl+a; type_text "stage=join"; press Return
says breakpoints '\[ "stage=join" \]'
says breakpoint_hits '\[ [1-9][0-9]* \]'
press Escape
press Home; says pivot 0
press F5; says address "[0-9]+\.join\.1"

# Its menu removes one.
go_to p40; says selected 40; press F9
says breakpoints '\[ "stage=join", "point=40" \]'
click_on "breakpoint 2 options"; click_on "breakpoint 2 away"
says breakpoints '\[ "stage=join" \]'
press Escape Escape; says selected null

# Ctrl and a left drag around points.
read -r x y < <(inside "region view" 35 35)
move_to "$x" "$y"
act 2 xdotool keydown ctrl mousedown 1
for step in "160 0" "0 160" "-160 0" "0 -120"; do
    read -r dx dy <<<"$step"
    act 1 xdotool mousemove_relative -- $((dx / 2)) $((dy / 2))
    act 1 xdotool mousemove_relative -- $((dx / 2)) $((dy / 2))
done
xdotool mouseup 1 keyup ctrl
says breakpoints '\[ "stage=join", "among=[0-9.,]+" \]'
leaves marked 0

# Watch: the value at the cursor, and a click in the plot.
press ctrl+p; type_text "watch"; press Return
says open_tab Watch
click_on "add watch"
click_on "watch term ring"
says watches '\[ "ring" \]'
leaves watch_values "[ null ]"
read -r x y < <(inside "watch plot 1" 50 50)
click "$x" "$y"
says pivot "$((end / 2 - 2))|$((end / 2 - 1))|$((end / 2))|$((end / 2 + 1))|$((end / 2 + 2))"

# All of it is in the session.
press ctrl+s
type_text "$work/stops.sesession"; press Return
poll test -f "$work/stops.sesession"
grep -q '"stage=join"' "$work/stops.sesession" || fail "the session has no breakpoint"
stop
start "$work/stops.sesession"
says phase ready
says breakpoints '\[ "stage=join", "among=[0-9.,]+" \]'
says watches '\[ "ring" \]'
stop
well
