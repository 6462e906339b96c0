#!/usr/bin/env bash
# A trace of another implementation beside the run: by --with, by File > Open and by its field; its
# fans are laid along with the run; the file is read again when it changes, and refused when faulty.
. "$(dirname "$0")/harness.sh"
cli=$(dirname "$viewer")/spiraling-edge
[ -x "$cli" ] || { echo "skipped: $cli is not built"; exit 77; }
traced() { "$cli" run scene:figure-8 -q --trace "$work/$1" "${@:2}" || fail "no trace"; }
traced same.setrace
traced mine.setrace --rule limits=off
start scene:figure-8 --with "$work/mine.setrace"
says layout compare; says compare_with trace; says compare_done true
says trace_difference "after 7 pivots alike, pivot 8 \(point 11 .*the fans differ.*"
says trace_guess "your whole trace, 83 pivots, behaves like --rule limits=off"
denies only_b 0
press d; says address "8\.limits\.1"
says trace_sentence "Pivot 8 of the trace: point 11 between 1 and 3, fan .*"
picture difference
# Its sentences lead to our decisions.
click_on "trace reason 2"; says address "8\.sphere\.1"
# In step before the difference: the fan is laid as ours is.
go_to 7.emit.1; says trace_sentence "Pivot 7 of the trace.*"; picture one
go_to 7; picture all
[ "$(differing one all 2%)" -gt 200 ] || fail "the fan of the trace is not laid"
go_to 8.limits.3
# Another trace is read in its place, at the same position; a faulty one is refused.
cp "$work/mine.setrace" "$work/kept"
head -c 300 "$work/kept" >"$work/mine.setrace"
says compare_refusal ".*mine\.setrace: line [0-9]+: .*"
says compare_done true; says trace_difference "after 7 pivots alike.*"
cp "$work/same.setrace" "$work/mine.setrace"
says trace_difference "all 83 pivots alike.*|all [0-9]+ pivots alike.*"
says compare_refusal ""; says address "8\.limits\.3"; says only_b 0
# It is kept.
press ctrl+s; says file_browser true
type_text "$work/kept"; press Return; says file_browser false
stop
start "$work/kept.sesession"
says layout compare; says compare_with trace; says compare_done true
click_on "compare stop"; says compare_with null
# As a file to open, it is compared with the open run.
cp "$work/kept" "$work/mine.setrace"
press ctrl+d; says layout debug
press ctrl+o; says file_browser true
type_text "$work/mine.setrace"; press Return
says layout compare; says compare_with trace; says compare_done true
says input scene:figure-8
stop
# Without an open run there is nothing to compare it with.
start
press ctrl+o; says file_browser true
type_text "$work/mine.setrace"; press Return
says notice ".*open these first.*"
stop
