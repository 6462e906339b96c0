#!/usr/bin/env bash
# Preparing in another way: neighbors, normals and walls derived as asked, marked, kept in a session.
. "$(dirname "$0")/harness.sh"
start sample:plane,n=400
says phase ready; says points 400
says derived '\[ "neighbors" \]'
go_to p12; says selected 12
press F1; says cheat_sheet true; press Escape
press ctrl+shift+r; says prepare true; sleep 0.3
read -r x y < <(inside "prepare count" 50 50); click "$x" "$y"
type_text "0"; press Return; sleep 0.3; says prepare true
click "$x" "$y"; type_text "9"
click_on "prepare Derived from the positions"; click_on "prepare The box around all points"; click_on "prepare ok"
says prepare false; says phase ready; says pivot 0; says selected 12
says derived '\[ "neighbors", "normals", "types" \]'
# It is kept, and Esc changes nothing.
press ctrl+s; says file_browser true; sleep 0.3
type_text "$work/kept"; sleep 0.2; press Return; says file_browser false
grep -q '"normals": "derived"' "$work/kept.sesession" || fail "the session forgets the normals"
grep -q '"box": "auto"' "$work/kept.sesession" || fail "the session forgets the box"
grep -q '"neighbors": 9' "$work/kept.sesession" || fail "the session forgets the neighbors"
press ctrl+shift+r; says prepare true; press Escape; says prepare false; says selected 12
stop
start "$work/kept.sesession"; says phase ready
says derived '\[ "neighbors", "normals", "types" \]'
stop
start sample:plane,n=400 --orient -k 8 --symmetric --box=-1,-1,-1,1,1,1
says derived '\[ "neighbors", "orientation", "types" \]'
stop
well
