#!/usr/bin/env bash
# Files dropped on the window, as a file manager does: points, a session, a missing file,
# two at once; and with unsaved notes.
. "$(dirname "$0")/harness.sh"
[ -n "$xlib_python" ] || { echo "skipped: python3-xlib is not installed"; exit 77; }
drop() { "$xlib_python" "$(dirname "${BASH_SOURCE[0]}")/xdnd.py" "$window" "$@" || fail "the drop of $* fails"; }

printf '%s\n' "0 0 0 0 0 1" "1 0 0 0 0 1" "0 1 0 0 0 1" "1 1 0 0 0 1" >"$work/four points.xyz"
cat >"$work/torus.sesession" <<'END'
{"format": "spiraling-edge session", "version": 1, "input": {"source": "scene:torus"},
 "address": "137.sphere.3", "layers": {"normals": "on", "hologram": "on"}, "notes": "from the file"}
END

# Points, onto the start page; a space in the name arrives as %20.
start
says start_page true
drop "$work/four points.xyz"
says input "four points.xyz"; says points 4

# A session goes to its position with its notes; an unknown layer is reported.
drop "$work/torus.sesession"
says input scene:torus; says address "137\.sphere\.3"; says notes "from the file"
says pins '.*"normals": "on".*'
says message '.*Ignored, since unknown in this version.*'
grep -q 'hologram' "$state" || fail "the layer is not named"

# A missing file leaves everything unchanged.
drop "$work/missing.ply"
says phase failed
says notes "from the file"
press ctrl+r; says phase failed
click_on "go on"; says phase ready
says input scene:torus; says address "137\.sphere\.3"

# Of two the first is opened, and a message reports it.
drop "$work/four points.xyz" "$work/torus.sesession"
says input "four points.xyz"
says message "2 files were dropped; only one was opened.*"

# With an unsaved bookmark the program asks first.
says alert_search done; says busy false
press Home; says pivot 0 # it may have opened on its first alert
press F10; says pivot 1
press ctrl+b; says unsaved true
drop "$work/torus.sesession"
says asks true; says input "four points.xyz"
drop "$work/torus.sesession"; says asks true
press Escape; says asks false; says input "four points.xyz"; says unsaved true
drop "$work/torus.sesession"
says asks true; click_on "leave discard"
says asks false; says input scene:torus
stop
well
