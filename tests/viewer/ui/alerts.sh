#!/usr/bin/env bash
# The panel of alerts, their moments, and the rule that would have prevented one.
. "$(dirname "$0")/harness.sh"
failing=${TMPDIR:-/tmp}/failing-$$.xyz
trap 'rm -f "$failing"; cleanup' EXIT

# reach NAME: turns the wheel over the panel until NAME is visible.
reach() {
    local x y rx ry rw rh
    for _ in $(seq 40); do
        read -r x y < <(center "$1") || exit 1
        read -r rx ry rw rh < <(field "region find" | tr -d '[],')
        [ "$y" -gt $((ry + 60)) ] && [ "$y" -lt $((ry + rh - 12)) ] && return 0
        click $((rx + rw / 2)) $((ry + rh - 40)) "$([ "$y" -gt $((ry + 60)) ] && echo 5 || echo 4)"
    done
    fail "$1 does not come into sight"
}

# A scene of a good run opens at the decision that it demonstrates, with no panel in the way; in
# every layout, except with a named position.
start scene:torus
says alert_search done; says alerts "[0-9]+"; says address "200\.split\.1"
denies open_tab Alerts
stop
for layout in learn present compare; do
    start scene:figure-8 --layout "$layout"; says phase ready; says layout "$layout"
    says address "9\.sphere\.2"
    stop
done
start scene:figure-8 --goto 3; says pivot 3; stop

# A scene that fails opens on its decision, with its alert.
size=1600x980 start scene:four-edge-hole
says alert_search done; says address 54.sphere.1; says alert "intersecting_triangles:[0-9]+"
says open_tab Paper
click_on "tab Alerts"; says open_tab Alerts
# The moments of the alert, by the mouse; each has its reason below its address.
reach "alert created"; click_on "alert created"; says address 54.emit.[12]; says noticed "[1-9]"
reach "alert unavoidable"; click_on "alert unavoidable"; says address 54.sphere.1
reach "alert first touched"; click_on "alert first touched"; says pivot "[0-9]|[1-7][0-9]"
# The place of the alert is the only one; the first of a run is shown on the finished mesh, framed,
# with its most severe fault selected.
press F8; says message "Place 2 of 2: .*"; press F8; says message "This is the last place."
press Escape; says alert ""
picture before
press F8; says place 1; says at_end true; says message "Place 1 of 2: .*"
picture after
[ "$(differing before after)" -gt 500 ] || fail "the place is not framed"
says selection "triangle|edge|point"
# Esc clears the selection and the alert.
press Escape; says alert ""; says selection none

# Which rule would have prevented it, and one click that turns it on.
press F8; says alert ".+:[0-9]+"
alerts=$(field alerts)
reach "alert remedies"; click_on "alert remedies"
says "remedy [a-z]+" "\[.*"
rule=$(grep -oE '"remedy [a-z]+"' "$state" | head -n 1 | tr -d '"')
# First beside the open run, at the same position; then instead of it.
at=$(field address)
reach "beside ${rule#remedy }"; click_on "beside ${rule#remedy }"
says compare_with run; says compare_done true; says address "$at"
press ctrl+d; says compare_done true
reach "$rule"
camera=$(field camera | sed 's/[][{}.*+?()|^$\\]/\\&/g')
click_on "$rule"
leaves alerts "$alerts"; says phase ready; says alert_search done
# The result is visible: the whole new mesh, from the same camera.
says at_end true; says camera "$camera"
[ "$(field alerts)" -lt "$alerts" ] || fail "the rule does not help: $(field alerts) alerts, $alerts before"
stop

# A file that fails opens on its finished mesh, with a card that says what is wrong and what to do;
# in three actions it is repaired and saved.
awk 'BEGIN { srand(3); for (y = 0; y < 14; ++y) for (x = 0; x < 14; ++x)
         if ((x - 7) ^ 2 + (y - 7) ^ 2 > 2) print x + 0.3 * sin(7 * x + 3 * y), y + 0.3 * sin(5 * x + 11 * y), 0, 0, 0, 1
     }' >"$failing"
size=1600x980 start "$failing"
says alert_search done; says alerts "[1-9][0-9]*"
says at_end true; says verdict "[0-9]+ places?: .*"; says place 0
# The card grows by the lines of the trials.
says trials_ended true
click_on "verdict worst"; says place 1; says alert ".+:[0-9]+"; says open_tab Alerts
click_on "verdict why"; says open_tab Ledger
before=$(field verdict)
says trials_ended true; says trial_best ".+"
# The pointer on Fix, or on its numbers, shows on the mesh what changes.
for name in "verdict fix" "verdict numbers"; do
    says tinted 0
    read -r x y < <(center "$name") || exit 1
    move_to "$x" "$y"; says tinted "[1-9][0-9]*"
    read -r x y < <(inside "region view" 70 80) || exit 1
    move_to "$x" "$y"
done
says tinted 0
click_on "verdict fix"
says alert_search done; says at_end true
leaves verdict "$before"
says message ".*Now .*; before, $before\..*"
click_on "verdict save"; says file_browser true
press Escape
click_on "verdict steps"; says pivot 0
press End; says at_end true
# The card is closed by its button, and comes back by the menu or the palette.
click_on "verdict close"
press End; denies "verdict card" "\[.*"
stop

# From afar the places are too small to be seen: pins stand for them, and a click on one goes to its
# most severe place, which is seen at its size then.
start scene:noise
press End; says at_end true; says alert_search done; press 1 shift+f; denies "pin 1" "\[.*"
read -r x y < <(inside "region view" 70 80) || exit 1
for _ in $(seq 8); do click "$x" "$y" 5; done
says "pin 1" "\[.*"
far=$(field camera)
click_on "pin 1"; says place 1; says message "Place 1 of .*"
leaves camera "$far"
denies "pin 1" "\[.*"
stop
well
