#!/usr/bin/env bash
# Unsaved notes, bookmarks, breakpoints and watches raise a question before they are left.
. "$(dirname "$0")/harness.sh"
# Effect of a window's close button: a message, not a forced end.
ask_to_close() {
    "$xlib_python" - "$window" <<'END' || fail "the window cannot be asked to close"
import sys
from Xlib import X, display
from Xlib.protocol import event
d = display.Display()
w = d.create_resource_object("window", int(sys.argv[1]))
w.send_event(event.ClientMessage(window=w, client_type=d.intern_atom("WM_PROTOCOLS"),
                                 data=(32, [d.intern_atom("WM_DELETE_WINDOW"), X.CurrentTime, 0, 0, 0])))
d.flush()
END
}
gone() {
    for _ in $(seq $looks); do kill -0 "$program" 2>/dev/null || break; sleep 0.05; done
    kill -0 "$program" 2>/dev/null && fail "the program does not leave"
    wait "$program" || fail "the exit code is $?"
    program=
}

# Without annotations there is no question.
start scene:sphere; says phase ready
press F10 F10; click_on "region view"; press n t
press ctrl+b ctrl+b; says unsaved false
stop

# Quitting asks; Esc stays, keys have no effect under the question.
start scene:sphere; says phase ready
press F10; says pivot 1
press ctrl+b; says unsaved true
press ctrl+q; says asks true
press F10 n; denies pivot 2
press Escape; says asks false; says pivot 1; says unsaved true
# So does reloading, and opening another file.
press ctrl+r; says asks true; press Escape; says asks false; says unsaved true
press ctrl+o; says file_browser true
type_text "scene:torus"; press Return; says asks true; says input scene:sphere
press Escape; says asks false; says input scene:sphere; says bookmarks '.*"1\.advance\.1".*'

# A breakpoint counts as well, and is named; after its removal there is no question.
press ctrl+b; says unsaved false
go_to 5.sphere.1; says address "5\.sphere\.1"; press F9; says unsaved true
titled() { [[ $(title) == *"$1"* ]]; }
poll titled "(unsaved breakpoints)" || fail "the title says $(title)"
press ctrl+q; says asks true; press Escape; says asks false
press F9; says unsaved false
go_to 1; says pivot 1; press ctrl+b; says unsaved true

# Saving asks for a name; without one nothing changes.
press ctrl+q; says asks true
press Return; says asks false; says file_browser true
press Escape; says file_browser false; says unsaved true
kill -0 "$program" 2>/dev/null || fail "it quits without saving"
press ctrl+q; says asks true; click_on "leave save"; says file_browser true
type_text "$work/kept"; press Return
gone
grep -q '"1\.advance\.1"' "$work/kept.sesession" || fail "the bookmark is not saved"

# The session has a name: saving continues at once.
start "$work/kept.sesession"; says bookmarks '.*"1\.advance\.1".*'; says unsaved false
go_to 7; says pivot 7; press ctrl+b; says unsaved true
press ctrl+r; says asks true; press Return; says asks false; says unsaved false; says pivot 0
grep -q '"7\.advance\.1"' "$work/kept.sesession" || fail "reloading does not save first"

# The close button asks as well; discarding leaves the file unchanged.
go_to 9; says pivot 9; press ctrl+b; says unsaved true
if [ -n "$xlib_python" ]; then
    ask_to_close; says asks true; press Escape; says asks false
    ask_to_close
else
    press ctrl+q
fi
says asks true; click_on "leave discard"
gone
grep -q '"9\.advance\.1"' "$work/kept.sesession" && fail "what was discarded is saved"
well
