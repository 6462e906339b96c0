#!/usr/bin/env bash
# The view of a decision: F goes there, Follow goes to each one, V swings and returns. The section
# is turned by keys and by a drag.
. "$(dirname "$0")/harness.sh"
escaped() { printf '%s' "$(field camera)" | sed 's/[][{}.*+?()|^$\\]/\\&/g'; }

start scene:torus --goto 137.sphere.1
says address "137\.sphere\.1"
says follow false
# It is opened in the view that F goes to.
opened=$(escaped)
press Return; denies camera "$opened"
home=$(escaped)
press f
denies camera "$home"
# The same again: nothing to do.
best=$(escaped); press f; says camera "$best"
# Without Follow the camera never moves by itself.
press F11 F11 F10
says pivot 138
says camera "$best"

# Follow goes to the decision at once, and to that of the next pivot; a test of the same pivot that
# is seen from the same side moves nothing.
press shift+v
says follow true
denies camera "$best"
here=$(escaped); go_to 139.sphere.1; denies camera "$here"
here=$(escaped); press F11; says address "139\.sphere\.2"; says camera "$here"
# It leaves nothing to undo.
depth=$(field undo)
go_to 145.sphere.1
says undo "$depth"
# A drag wins over the move.
read -r x y < <(inside "region view" 20 80)
here=$(escaped); drag "$x" "$y" 60 20; denies camera "$here"
here=$(escaped); press F11; says camera "$here"
press shift+v
says follow false
here=$(escaped); press F10; says camera "$here"

# A swing ends where it began.
depth=$(field undo)
press v
says camera "$here"
says undo "$depth"

# Learn and Present follow, Debug does not.
press F2; says layout learn; says follow true
press F2; says layout present; says follow true
press F2; says layout debug; says follow false

# The section.
press r
says open_tab Section
says section_degrees "15\.0"
press r shift+r shift+r shift+r
says section_degrees "-15\.0"
read -r x y < <(center "section")
drag "$x" "$y" 32 0
says section_degrees "-[0-9.]+|[0-9.]+"
denies section_degrees "-15\.0"
stop
well
