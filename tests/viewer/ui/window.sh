#!/usr/bin/env bash
# The window from start to end: exit codes, the same picture as without a display, the title.
. "$(dirname "$0")/harness.sh"

env -u DISPLAY -u WAYLAND_DISPLAY "$viewer" --no-config scene:sphere 2>"$work/no-display.txt"
[ $? -eq 4 ] || fail "without a display the exit code is not 4"
grep -q -- "--screenshot" "$work/no-display.txt" || fail "the message does not name --screenshot"
grep -q "xvfb-run" "$work/no-display.txt" || fail "the message does not name xvfb-run"
[ "$(wc -l <"$work/no-display.txt")" -eq 1 ] || fail "the message is more than one line"
env -u DISPLAY -u WAYLAND_DISPLAY "$viewer" scene:sphere --goto 20 --size 1000x700 \
    --screenshot "$work/offscreen.png" || fail "no picture without a display"
env -u DISPLAY "$viewer" --no-config "$work/missing.ply" --screenshot "$work/x.png" 2>/dev/null
[ $? -eq 3 ] || fail "a missing file does not lead to exit code 3"
"$viewer" --size nonsense 2>/dev/null
[ $? -eq 2 ] || fail "wrong usage does not lead to exit code 2"
"$viewer" scene:sphere --goto 999999 --screenshot "$work/x.png" 2>"$work/err.txt"
[ $? -eq 2 ] || fail "a place beyond the end does not lead to exit code 2"
grep -q "999999" "$work/err.txt" || fail "the message does not name the place"
"$viewer" scene:sphere --goto p12 --screenshot "$work/x.png" || fail "--goto p12 fails"
"$viewer" scene:sphere --screenshot "$work/none/x.png" 2>"$work/err.txt"
[ $? -eq 2 ] || fail "a missing folder does not lead to exit code 2"
grep -q "there is no folder" "$work/err.txt" || fail "the message does not say that the folder is missing"

# Also with what is no session, no points, or more than the memory holds.
echo '{"format": 1}' >"$work/bad.sesession"
"$viewer" "$work/bad.sesession" 2>"$work/err.txt"
[ $? -eq 3 ] || fail "a bad session does not lead to exit code 3"
grep -q 'bad\.sesession.*format.*expected' "$work/err.txt" || fail "the message does not say what was expected"
"$viewer" - --screenshot "$work/x.png" </dev/null 2>"$work/err.txt"
[ $? -eq 3 ] && grep -q "standard input: is empty" "$work/err.txt" || fail "an empty standard input is no error"
ln -s /dev/zero "$work/zero.nrrd"
printf 'NRRD0001\ntype: float\ndimension: 3\nsizes: 4 4 4\nencoding: raw\nendian: little\ndata file: zero.nrrd\n' >"$work/a.nhdr"
printf '{"format": "spiraling-edge session", "version": 1, "input": {"source": "sample:a.nhdr,n=100,iso=0"}}' >"$work/zero.sesession"
"$viewer" "$work/zero.sesession" --screenshot "$work/x.png" 2>"$work/err.txt"
[ $? -eq 3 ] && grep -q "expected a regular file" "$work/err.txt" || fail "a device is read as a volume"
"$viewer" scene:torus --with "$work/nothing.ply" --screenshot "$work/x.png" 2>"$work/err.txt" && fail "a missing mesh is no error"
grep -q 'nothing\.ply' "$work/err.txt" || fail "the message does not name the missing mesh"
(ulimit -v 3000000; "$viewer" /dev/zero --most-bytes 100000000000 --screenshot "$work/x.png" 2>"$work/err.txt")
[ $? -eq 3 ] && grep -q "Out of memory" "$work/err.txt" || fail "the end of the memory is no error"

# A picture of a session shows its position, any other picture the end of the run.
program_beside=$(dirname "$viewer")/spiraling-edge
if [ -x "$program_beside" ]; then
    printf '{"format": "spiraling-edge session", "version": 1, "input": {"source": "scene:sphere"}, "address": "40.sphere.2"}' >"$work/a.sesession"
    # render hands over to the viewer beside it.
    mkdir "$work/bin"
    cp "$program_beside" "$work/bin/spiraling-edge"
    ln -s "$driven" "$work/bin/spiraling-edge-viewer"
    render=("$work/bin/spiraling-edge" render)
    "${render[@]}" "$work/a.sesession" -o "$work/x.png" || fail "render of a session fails"
    [ "$(field address)" = "40.sphere.2" ] || fail "render SESSION shows '$(field address)'"
    "${render[@]}" "$work/a.sesession" -o "$work/x.png" --goto 7 || fail "render of a session fails"
    [[ $(field address) == 7.* ]] || fail "render SESSION --goto 7 shows '$(field address)'"
    "$program_beside" sample torus -n 300 -q -o "$work/torus.ply" || fail "no points are sampled"
    "$viewer" - --goto 100% --screenshot "$work/stdin.png" < <(cat "$work/torus.ply") || fail "no picture of standard input"
    [ -s "$work/stdin.png" ] || fail "no picture of standard input"
    "${render[@]}" scene:sphere -o "$work/x.png" || fail "render of a scene fails"
    [ "$(field pivot)" -gt 100 ] || fail "render of a scene shows '$(field address)', not the end"
fi

size=1000x700 start scene:sphere --no-config --narrate
says phase ready
says input scene:sphere
for _ in $(seq 20); do press F10; done
says address "20\.advance\.1"
case "$(title)" in "20.advance.1"*) ;; *) fail "the title is '$(title)'" ;; esac
# An address of the command line is opened in the view that F goes to.
press f; says moving false
picture window
[ "$(differing window offscreen 12%)" -lt 35000 ] || fail "the picture off screen is another"
# Equal frames are not drawn again, but for a part that another window has covered.
if [ -n "$xlib_python" ]; then
    cover() {
        "$xlib_python" - <<'END' || fail "the window cannot be covered"
from Xlib.display import Display
display = Display()
screen = display.screen()
cover = screen.root.create_window(0, 0, 1700, 1000, 0, screen.root_depth, override_redirect=True,
                                  background_pixel=screen.white_pixel)
cover.map()
display.sync()
cover.destroy()
display.sync()
END
    }
    says moving false; picture before
    act 1 cover
    picture uncovered
    [ "$(differing before uncovered)" -lt 100 ] || fail "a part that was covered is not drawn again"
fi
go_to 40.sphere.2
says address "40\.sphere\.2"
grep -q "^40\.sphere\.2.*Point .* lies .* removed\.$" "$work/program.log" || fail "--narrate prints no sentence"
press Escape
kill -0 "$program" 2>/dev/null || fail "Esc quits"
stop
[ "$(field address)" = "40.sphere.2" ] || fail "the state was not written on leaving"
[ -z "$(ls -A "$XDG_CONFIG_HOME")" ] || fail "--no-config writes settings"

# Size and layout of the window are kept.
size=kept start scene:grid; says phase ready; press F2; says layout present; resize 1100 700; stop
size=kept start scene:grid; says phase ready; says layout present
poll is_wide 1100 || fail "the window opens with another size: $(field "region strip")"
stop
start scene:grid --reset-layout; says layout debug; stop
start scene:grid; says layout debug; stop
# The pointer does not move for a number of frames.
timeout 600 "$viewer" scene:sphere --no-config --frames 30 || fail "--frames does not end"

# Points of a pipe; reloading takes them from memory, and a session cannot refer to them.
mkfifo "$work/pipe"
awk 'BEGIN { for (i = 0; i < 300; ++i) { z = 1 - (2 * i + 1) / 300; r = sqrt(1 - z * z)
     x = r * cos(i * 2.39996323); y = r * sin(i * 2.39996323); print x, y, z, x, y, z } }' >"$work/pipe" &
stdin=$work/pipe start -
says input "standard input"; says points 300; says pivot 0
press End; leaves pivot 0
press ctrl+r; says input "standard input"; says points 300; says pivot 0
press ctrl+s; says notice ".*came from standard input.*"
stop
well
