#!/usr/bin/env bash
# Moving in the run: the strips are dragged, clicked, zoomed and folded, the tree of steps is filtered.
. "$(dirname "$0")/harness.sh"
start scene:torus --goto 137.sphere.2
says address "137\.sphere\.2"
says drawer open
says whole true
says lanes 1

# RUN: a click goes there, a drag follows, the wheel zooms, a double click shows the whole run.
read -r x y < <(inside "strip run" 50 60)
click "$x" "$y"
says pivot "3[45][0-9]"
says lanes 3
drag "$x" "$y" 200 0
says pivot "4[0-9][0-9]"
click "$x" "$y" 4; click "$x" "$y" 4
says whole false
move_to "$x" "$y"; xdotool click --repeat 2 --delay 160 1
says whole true

# STAGE and PIVOT: cells go to their tests.
go_to 137.sphere.1
says address "137\.sphere\.1"
read -r x y < <(inside "strip stage" 18 50)
click "$x" "$y"
says address "137\.sphere\.2"
read -r x y < <(inside "strip pivot" 1 50)
click "$x" "$y"
says address "137\.pivot\.1"
click "$x" "$y" 5
says pivot 138

# The drawer is folded and opened.
press ctrl+j; says drawer folded
press ctrl+j; says drawer open

# The tree: fewer rows with a filter.
rows=$(field rows)
read -r x y < <(inside "region left" 40 8)
click "$x" "$y"
type_text "split"
says filter split
denies rows "$rows"
press Return
stop
size=1024x640 start scene:torus --goto 137
says drawer folded
stop
well
