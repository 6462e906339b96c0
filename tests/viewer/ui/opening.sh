#!/usr/bin/env bash
# A million points: the window is there at once, shows the progress, and can be stopped and closed.
. "$(dirname "$0")/harness.sh"
count=${POINTS:-1000000}
python3 "$(dirname "${BASH_SOURCE[0]}")/../../bench/sphere_ply.py" "$count" "$work/many.ply" ||
    fail "no points can be made"

start "$work/many.ply"
says phase loading
# In its first frame it has no size yet.
click_on "cancel opening"
says phase empty; says start_page true
# Opened again from here; quitting does not wait for it either.
press ctrl+o; says file_browser true
type_text "$work/many.ply"; press Return; says phase loading
began=$(date +%s%N)
stop
quitting=$((($(date +%s%N) - began) / 1000000))

# The open input stays usable while another one is being opened.
start scene:sphere; says phase ready
press ctrl+o; says file_browser true
type_text "$work/many.ply"; press Return; says phase loading
says input scene:sphere
says input many.ply; says points "$count"; says pivot 0
stop
window=$(field first_window_seconds) longest=$(field longest_opening_seconds)
echo "$count points: at most $longest s from frame to frame while opening"
awk "BEGIN { exit !($longest < 2) }" || fail "the window hangs for $longest s"

for input in scene:torus "$work/many.ply"; do
    start "$input"; says phase ready
    echo "$input: window after $(field first_window_seconds) s, input after $(field first_frame_seconds) s," \
        "at most $(field longest_opening_seconds) s from frame to frame"
    window=$(field first_window_seconds)
    awk "BEGIN { exit !($window < 3) }" || fail "the window needs $window s"
    stop
done
# Measured in the same run: quitting is not the opening waited for.
opened=$(field first_frame_seconds)
echo "quitting took $quitting ms while opening takes $opened s"
awk "BEGIN { exit !($quitting < 500 * $opened) }" || fail "quitting waits for the input"
well
