#!/usr/bin/env bash
# Opens the real window under a virtual display, presses keys and checks what happens.
#   drive_window.sh VIEWER
# Leaves 0 if all is well, 77 (skipped) if Xvfb or xdotool is not installed.
set -u
viewer=$1
for tool in Xvfb xdotool compare import; do
    command -v "$tool" >/dev/null || { echo "skipped: $tool is not installed"; exit 77; }
done

work=$(mktemp -d)
server=
program=
cleanup() {
    [ -n "$program" ] && kill "$program" 2>/dev/null
    [ -n "$server" ] && kill "$server" 2>/dev/null
    rm -rf "$work"
}
trap cleanup EXIT
fail() {
    echo "FAILED: $*" >&2
    [ -f "$work/program.log" ] && cat "$work/program.log" >&2
    exit 1
}

# --- Without a display -------------------------------------------------------------------------
env -u DISPLAY -u WAYLAND_DISPLAY "$viewer" --no-config scene:sphere 2>"$work/no-display.txt"
code=$?
[ $code -eq 4 ] || fail "without a display the exit code is $code, not 4"
grep -q -- "--screenshot" "$work/no-display.txt" || fail "the message does not name --screenshot"
grep -q "xvfb-run" "$work/no-display.txt" || fail "the message does not name xvfb-run"
[ "$(wc -l <"$work/no-display.txt")" -eq 1 ] || fail "the message is more than one line"

size=1000x700
env -u DISPLAY -u WAYLAND_DISPLAY "$viewer" scene:sphere --goto 20 --size $size \
    --screenshot "$work/offscreen.png" || fail "no picture without a display"
env -u DISPLAY "$viewer" --no-config "$work/missing.ply" --screenshot "$work/x.png" 2>"$work/err.txt"
[ $? -eq 3 ] || fail "a missing file does not lead to exit code 3"
"$viewer" --size nonsense 2>/dev/null
[ $? -eq 2 ] || fail "wrong usage does not lead to exit code 2"

# --- A display of our own ----------------------------------------------------------------------
mkfifo "$work/number"
Xvfb -displayfd 3 -screen 0 1400x900x24 -nolisten tcp -noreset 3>"$work/number" 2>/dev/null &
server=$!
read -r -t 20 number <"$work/number" || fail "Xvfb does not start"
export DISPLAY=:$number
unset WAYLAND_DISPLAY

"$viewer" scene:sphere --no-config --size $size --ui-scale 1 --theme dark --narrate \
    --state-dump "$work/state.json" >"$work/program.log" 2>&1 &
program=$!

title() { xdotool getwindowname "$window" 2>/dev/null; }
# Waits up to 10 seconds for a title that begins with $1.
expect() {
    for _ in $(seq 100); do
        case "$(title)" in "$1"*) return 0 ;; esac
        kill -0 "$program" 2>/dev/null || fail "the program is gone while waiting for '$1'"
        sleep 0.1
    done
    fail "expected a title beginning with '$1', found '$(title)'"
}
press() { xdotool key --clearmodifiers "$@"; sleep 0.12; }

window=
for _ in $(seq 100); do
    window=$(xdotool search --onlyvisible --name "Spiraling Edge" 2>/dev/null | head -n 1)
    [ -n "$window" ] && break
    sleep 0.1
done
[ -n "$window" ] || fail "no window appears"
xdotool windowfocus --sync "$window"
expect "start"

for _ in $(seq 20); do press F10; done
expect "20.advance.1"
sleep 0.6
import -window "$window" "$work/window.png" || fail "cannot read the window"
pixels=$((1000 * 700))
differing=$(compare -metric AE -fuzz 12% "$work/window.png" "$work/offscreen.png" null: 2>&1)
differing=${differing%%[!0-9]*}
[ -n "$differing" ] || fail "the pictures cannot be compared"
[ "$differing" -lt $((pixels / 20)) ] || fail "$differing of $pixels pixels differ from the picture off screen"

press Right; expect "21."
press Left; expect "20.advance.1"
press Left; sleep 0.3
case "$(title)" in 20.advance*) fail "Left does not leave the last event" ;; 20.*) ;; *) fail "Left went to '$(title)'" ;; esac
press shift+F11; expect "20.advance.1"
press shift+F10; expect "19.advance.1"
press period; expect "20.advance.1"
press comma; expect "19.advance.1"
press ctrl+g; xdotool type --delay 60 "12.sort.2"; press Return
expect "12.sort.2"
# Back and forward, marks, and a place as text.
press ctrl+g; xdotool type --delay 60 "40.sphere.2"; press Return
expect "40.sphere.2"
press alt+Left; expect "12.sort.2"
press alt+Right; expect "40.sphere.2"
press ctrl+c; sleep 0.2
press Home; expect "start"
press ctrl+v; expect "40.sphere.2"
grep -q "^40\.sphere\.2.*q = .* removed\.$" "$work/program.log" || fail "--narrate prints no sentence"
press Home; expect "start"
press ctrl+Right; expect "1.seed.1"
press ctrl+g; xdotool type --delay 60 "12.sort.2"; press Return
expect "12.sort.2"
press space; sleep 1.2; press space; sleep 0.3
played=$(title)
[ "${played%%.*}" -gt 12 ] || fail "Space does not play: '$played'"
press End; sleep 0.5
ended=$(title)
[ "${ended%%.*}" -gt 100 ] || fail "End does not run to the end: '$ended'"
press Home; expect "start"
press ctrl+p; sleep 0.4; xdotool type --delay 60 "next pivot"; sleep 0.3; press Return
expect "1."
press Home; expect "start"
press F1; sleep 0.3
import -window "$window" "$work/keys.png"
press Escape; sleep 0.3
import -window "$window" "$work/plain.png"
changed=$(compare -metric AE -fuzz 5% "$work/keys.png" "$work/plain.png" null: 2>&1)
[ "${changed%%[!0-9]*}" -gt $((pixels / 20)) ] || fail "F1 shows no list of keys"
kill -0 "$program" 2>/dev/null || fail "Esc quits"

# The mouse: a drag turns, a click selects.
xdotool mousemove --window "$window" 480 300; sleep 0.2
xdotool mousedown 1; sleep 0.1
xdotool mousemove_relative --sync 60 20; sleep 0.2
xdotool mouseup 1; sleep 0.4
import -window "$window" "$work/turned.png"
turned=$(compare -metric AE -fuzz 5% "$work/plain.png" "$work/turned.png" null: 2>&1)
[ "${turned%%[!0-9]*}" -gt 1000 ] || fail "a drag does not turn the view"

press Escape; sleep 0.2
press ctrl+g; xdotool type --delay 60 "40.sphere.2"; press Return
expect "40.sphere.2"
press n; sleep 0.3

press ctrl+q
for _ in $(seq 50); do kill -0 "$program" 2>/dev/null || break; sleep 0.1; done
kill -0 "$program" 2>/dev/null && fail "Ctrl+Q does not quit"
wait "$program"
code=$?
program=
[ $code -eq 0 ] || fail "the exit code is $code"
# says NAME VALUE: does the state that was written on leaving say so?
says() { grep -qE "\"$1\": $2,?\$" "$work/state.json" || fail "the state does not say $1: $2"; }
says address '"40\.sphere\.2"'
says phase '"ready"'
says input '"scene:sphere"'
says pivot 40
says playing false
grep -q '"normals"' "$work/state.json" || fail "N does not switch normals on"
echo "all is well"
