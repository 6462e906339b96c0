#!/usr/bin/env bash
# The start page by keyboard alone: Tab to files and scenes, arrows from one to the next, Enter opens.
. "$(dirname "$0")/harness.sh"
printf '0 0 0 0 0 1\n1 0 0 0 0 1\n0 1 0 0 0 1\n1.1 1.2 0 0 0 1\n' >"${TMPDIR:-/tmp}/start-$$.xyz"
file=${TMPDIR:-/tmp}/start-$$.xyz
trap 'rm -f "$file"; cleanup' EXIT

# chosen NAME: it has the keyboard focus, and a frame shows it.
chosen() {
    says "chosen $1" "\[.*"
}
start
says start_page true; says keyboard view
picture before
press Tab; says keyboard files
press Tab; says keyboard scenes; chosen lesson:tour
picture first
[ "$(differing before first)" -gt 200 ] || fail "one cannot see which tile has the keyboard"
press Right; chosen lesson:spiral; picture second
[ "$(differing first second)" -gt 200 ] || fail "one cannot see that the arrow moves on"
press Down Left; chosen lesson:removal; press Up; chosen lesson:tour
press Tab; says keyboard view
press shift+Tab; says keyboard scenes
press Escape; says keyboard view; says start_page true
press Tab Tab; says keyboard scenes; chosen lesson:tour
press Down Down Down; chosen figure-1
press Right; chosen figure-2; press Return
says phase ready; says input scene:figure-2; says keyboard view
# It opens at the decision of the figure, beside its rule. The view has the focus: its keys work at
# once.
says address "5\.advance\.1"; says task Step
says decision ".*next pivot.*"
press F10; says pivot 6
press n; says pins '.*normals.*'
stop

# Below the drop area: new points, then recent files.
start "$file"; says phase ready; stop
start
says start_page true; says recent "[1-9]"
press Tab; says keyboard files
press Return; says file_browser true; press Escape; says file_browser false
press Tab; says keyboard files
press Down; chosen file.new.shape; press Down; chosen file.new.volume
press Down; chosen "recent 1"; press Return
says input "start-.*\.xyz"
stop
well
