#!/usr/bin/env bash
# The start page, sessions, recent files, layouts and undo, as a user meets them.
. "$(dirname "$0")/harness.sh"
start
says start_page true
says phase empty
# Keys of the run do nothing here; Enter opens only items reached by arrows or Tab (start.sh).
press F10 F5 f Return space 1 ctrl+b ctrl+z ctrl+s Home; says start_page true; says file_browser false
click_on "tile figure-1"
says start_page false
says input scene:figure-1; says layout learn
press F2; says layout present; press F2; says layout debug
stop
start scene:sphere
says input scene:sphere

# Undo and redo: layer, camera, selection, layout.
says undo 0
press n; says undo 1
says layers '.*"normals".*'
drag 600 300 80 20; says undo 2
go_to p12; says selected 12; says undo 3
press ctrl+z; says selected null; says message "Undone: selection\."
press ctrl+z; says undo 1; says redo 2
press ctrl+z; says undo 0
case "$(field layers)" in *normals*) fail "undo leaves the layer on" ;; esac
press ctrl+y; says layers '.*"normals".*'
press ctrl+shift+z ctrl+y; says selected 12; says redo 0
press Home; says pivot 0
press F2; says layout learn
press F2; says layout present
press F10; says pivot 1
press F2; says layout debug
press F2; says layout learn

# Bookmarks: Ctrl+B sets or removes one, Ctrl with a digit goes there; plain digits are views.
go_to 30.sort.1; says address "30\.sort\.1"
press ctrl+b; says bookmarks '.*"30\.sort\.1".*'
go_to 12.sort.2; says address "12\.sort\.2"
press ctrl+b; says bookmarks '.*"12\.sort\.2", "30\.sort\.1".*'
press F10; denies address "12\.sort\.2"
press ctrl+2; says address "30\.sort\.1"
press ctrl+1; says address "12\.sort\.2"
press ctrl+b; denies bookmarks '.*"12\.sort\.2".*'
press ctrl+z; says bookmarks '.*"12\.sort\.2".*'
press ctrl+equal; says em 20\.0
press ctrl+minus; says em 16\.0

# Another key for an action; a used one is reassigned at the second press.
press ctrl+p; type_text "change keys"; press Return; says key_editor true
click 640 400 5; click 640 400 5  # down the list
read -r x y w h < <(tr '\n' ' ' <"$state" | sed -E 's/ +/ /g' | sed -nE 's/.*"key run\.unit": \[([^]]*)\].*/\1/p' | tr -d ,)
click $((x + w / 2)) $((y + h / 2)); press y; says changed_keys 1
click $((x + w / 2)) $((y + h / 2)); press n; says changed_keys 1
press n; says changed_keys 2
press Escape; says key_editor false
unit=$(field unit)
press n; denies unit "$unit"
# Three units, then the first again.
press n n; says unit "$unit"
go_to p12; says selected 12

# A session is saved under a name that is requested once.
go_to 40.sphere.2; says address "40\.sphere\.2"
press ctrl+s; says file_browser true
type_text "$work/one"; press Return
says file_browser false
says session_file "$work/one\.sesession"
[ -f "$work/one.sesession" ] || fail "no session file is written"
press F10; says pivot 41
press ctrl+s
grep -q '"address": "41\.advance\.1"' "$work/one.sesession" || fail "the second save does not write"
says recent 1

# A text field keeps the keys that edit; Ctrl+S and function keys work, Esc leaves the text as it is.
says unsaved false; says title '.*one\.sesession.*'
press F2 F2; says layout debug
click_on "tab Notes"; says open_tab Notes
click_on "field notes"; type_text "look here n"
says notes "look here n"; says unsaved true; says title '.*unsaved.*'
pivot=$(field pivot)
press F10; says pivot $((pivot + 1))
press shift+F10; says pivot "$pivot"
press ctrl+s; says unsaved false
grep -q '"notes": "look here n"' "$work/one.sesession" || fail "Ctrl+S while typing does not save"
type_text "x"; says notes "look here nx"
press Escape; says notes "look here nx"
press F10; says pivot $((pivot + 1)); press comma; says pivot "$pivot"
press ctrl+s; says unsaved false
go_to 41; says address "41\.advance\.1"; press ctrl+s

# Under a dialog plain keys have no effect; a click beside the line returns the focus to it.
press ctrl+o; says file_browser true
before=$(field unit)$(field layers)
click 640 640; type_text "nlk"
[ "$(field unit)$(field layers)" = "$before" ] || fail "keys go through the file browser"
press Escape; says file_browser false
press F1; says cheat_sheet true; press n period; says pivot 41
[ "$(field unit)$(field layers)" = "$before" ] || fail "keys go through the cheat sheet"
press F1; says cheat_sheet false
for _ in 1 2 3 4 5; do
    press ctrl+p; says palette true
    xdotool type --delay 5 -- "next pivot"; xdotool key --delay 1 Return; says palette false
done
says pivot 46
press F2; says layout learn
go_to 41; says pivot 41; go_to p12; says selected 12; go_to 41; press ctrl+s
stop
grep -q '"run.unit": "N"' "$XDG_CONFIG_HOME/spiraling-edge/settings.json" || fail "the key is not kept"
[ -f "$XDG_STATE_HOME/spiraling-edge/state.json" ] || fail "no state is kept"

# It is restored; the command line takes precedence. The layout is kept without it as well.
start "$work/one.sesession"
says address "41\.advance\.1"; says selected 12; says layout learn
stop
start "$work/one.sesession" --goto 20 --layout present
says address "20\.advance\.1"; says layout present
stop
start scene:grid; says layout learn; says recent 1; stop
start scene:grid --reset-layout; says layout debug; stop
start scene:grid; says layout debug; stop

# A click on a recent file; without settings nothing is read and nothing is kept.
start; says start_page true
click_on "recent 1"; says input scene:sphere; says pivot 41
stop
before=$(cat "$XDG_STATE_HOME/spiraling-edge/state.json")
start --no-config; says recent 0; press F2; says start_page true; stop
[ "$before" = "$(cat "$XDG_STATE_HOME/spiraling-edge/state.json")" ] || fail "--no-config keeps a state"

# Errors are reported, with exit code 3.
echo '{"format": 1}' >"$work/bad.sesession"
"$viewer" "$work/bad.sesession" 2>"$work/err.txt"
[ $? -eq 3 ] || fail "a bad session does not lead to exit code 3"
grep -q 'bad\.sesession.*format.*expected' "$work/err.txt" || fail "the message does not say what was expected"
well
