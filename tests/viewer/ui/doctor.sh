#!/usr/bin/env bash
# The doctor's panel opens by itself when something is found, and stays where it is when nothing is.
. "$(dirname "$0")/harness.sh"

# A jittered lattice with a copy, and two normals that are zero.
awk 'BEGIN { for (y = 0; y < 12; ++y) for (x = 0; x < 12; ++x) {
         n = x == 4 && y < 2 ? 0 : 1
         print x + 0.11 * sin(7 * x + 3 * y), y + 0.13 * sin(5 * x + 11 * y), 0, 0, 0, n
         if (x == 9 && y == 9) print x + 0.11 * sin(7 * x + 3 * y), y + 0.13 * sin(5 * x + 11 * y), 0, 0, 0, n
     } }' >"${TMPDIR:-/tmp}/doctor-$$.xyz"
flawed=${TMPDIR:-/tmp}/doctor-$$.xyz
trap 'rm -f "$flawed"; cleanup' EXIT

start scene:torus
says doctor done
says findings '\[\]'
denies open_tab Doctor
stop

start "$flawed"
says doctor done
says findings '\[ "duplicates", "zero_normals" \]'
says open_tab Doctor
says marked 0
click_on "finding zero_normals"
says marked 2; sleep 0.3 # the frame after the click shows them
picture marked
click_on "finding zero_normals" # again: the marks go out
says marked 0; sleep 0.3
picture plain
[ "$(differing marked plain)" -gt 100 ] || fail "marks cannot be seen"
click_on "finding duplicates"
says marked 1
press Escape
says marked 0
# Somewhere else, and back by the action.
click_on "tab Counts"
says open_tab Counts
press ctrl+p
type_text "doctor says"
press Return
says open_tab Doctor
stop
well
