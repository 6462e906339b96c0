#!/usr/bin/env bash
# The doctor's panel opens by itself when something is found, and stays where it is otherwise.
. "$(dirname "$0")/harness.sh"
# What is found in the background moves the rows of the panel: waits until all is known.
at_rest() { says doctor done; says alert_search done; says trials_ended true; }

# A jittered lattice, which ends at no wall, with a copy, and two normals that are zero.
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

size=1600x980 start --layout learn "$flawed"
says doctor done
says findings '\[ "duplicates", "zero_normals", "open_border" \]'
# What the preparation set aside is counted, with the reason.
says aside '\{ "copy": 1 \}'
says open_tab Doctor
says marked 0
# The outcome of the trials takes a row above the findings.
says trials_ended true
click_on "finding zero_normals"
says marked 2; says moving false
picture marked
click_on "finding zero_normals" # again: the marks are cleared
says marked 0; says moving false
picture plain
[ "$(differing marked plain)" -gt 100 ] || fail "marks cannot be seen"
click_on "finding duplicates"
says marked 1
press Escape
says marked 0
# To another tab, and back by the action.
click_on "tab Rules"
says open_tab Rules
press ctrl+p
type_text "doctor"
press Return
says open_tab Doctor

# One finding is fixed: the input is opened again with the fix, and Ctrl+Z undoes it.
points=$(field points)
go_to 20; says pivot 20
at_rest; click_on "fix zero_normals"
says cures '\[ "zero_normals" \]'; says phase ready; says at_end true
says aside '\{ "zero_normals": 1 \}'
says mended '\[ "1 exact copy dropped", "2 normals that were zero or not finite derived" \]'
says points "$((points - 1))"
says doctor done; says findings '\[ "open_border" \]'
press Escape; press ctrl+z
says cures '\[\]'; says points "$points"; says findings '.*zero_normals.*'; says message "Undone: .*|"
press ctrl+y
says cures '\[ "zero_normals" \]'; says points "$((points - 1))"; says findings '\[ "open_border" \]'
# "Use the file as is" does the same, and can be undone like the rest.
at_rest; click_on "doctor as it is"
says cures '\[\]'; says points "$points"
press Escape; press ctrl+z
says cures '\[ "zero_normals" \]'; says points "$((points - 1))"
press ctrl+z; says cures '\[\]'; says findings '.*zero_normals.*'

# Points dropped by a fix come back by a click.
at_rest; click_on "fix duplicates"; says cures '\[ "duplicates" \]'; says points "$((points - 1))"
at_rest; click_on "return duplicates"
says cures '\[\]'; says points "$points"; says at_end true; says findings '.*zero_normals.*'

# The command can be pasted anywhere: with the whole path.
at_rest; click_on "copy zero_normals"; says notice "Copied the command\."
stop

# Normals that point the wrong way are flipped together with the repairs.
python3 -c '
import math
n = 900
for i in range(n):
    z = 1 - (2 * i + 1) / n
    r, a = math.sqrt(1 - z * z), i * math.pi * (3 - math.sqrt(5))
    x = (r * math.cos(a), r * math.sin(a), z)
    s = -1 if z > 0.6 else 2
    print(*x, *(s * c for c in x))
' >"$flawed" || fail "no points can be made"
size=1600x980 start --layout learn "$flawed"
says doctor done
says findings '.*"unscaled_normals".*"flipped_normals".*'
says trials_ended true
click_on "doctor fix all"
says phase ready; says mended '\[ "[0-9]+ normals scaled to unit length", "[0-9]+ normals flipped" \]'
says doctor done; says findings '\[\]'
# A session keeps it.
press Escape; press ctrl+s; says file_browser true
type_text "$work/cured"; press Return; says session_file ".*cured.sesession"
stop
start "$work/cured.sesession"
says phase ready; says cures '\[ "unscaled_normals", "flipped_normals" \]'
says doctor done; says findings '\[\]'
stop

# Two layers of a torus, as two scans that are not registered leave: the points are thinned to one
# surface in two clicks, and the mesh is sound.
python3 -c '
import math, random
chance = random.Random(4)
for layer in (0, 1):
    for i in range(1500):
        while True:
            a, b = (chance.uniform(-math.pi, math.pi) for _ in range(2))
            if chance.uniform(0, 1.4) <= 1 + 0.4 * math.cos(b):
                break
        r = 0.4 + 0.07 * layer
        print((1 + r * math.cos(b)) * math.cos(a), (1 + r * math.cos(b)) * math.sin(a), r * math.sin(b))
' >"$flawed" || fail "no points can be made"
size=1600x980 start --layout learn --rules robust "$flawed"
says doctor done; says findings '\[ "no_normals", "two_layers".*|\[ "two_layers".*'
says alert_search done; denies verdict "the mesh is sound"
# More than half of the points are dropped: that is asked first.
at_rest; click_on "fix two_layers"; says cures '\[\]'
click_on "fix two_layers"
says cures '\[ "two_layers" \]'; says phase ready; says doctor done; says findings '\[ "no_normals".*'
says alert_search done; says verdict "the mesh is sound"
stop
well
