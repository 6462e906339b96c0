#!/usr/bin/env bash
# Where points come from: standard input, and sessions that name endless inputs.
. "$(dirname "$0")/harness.sh"

# sphere POINTS: a spiral over the sphere, as XYZ with normals.
sphere() {
    awk -v n="$1" 'BEGIN { turn = 2.399963229728653
        for (i = 0; i < n; ++i) { z = 1 - (2 * i + 1) / n; r = sqrt(1 - z * z)
            x = r * cos(i * turn); y = r * sin(i * turn); print x, y, z, x, y, z } }'
}
# refused CODE SENTENCE ARGUMENTS...: the program ends at once, with a reason.
refused() {
    local wanted=$1 sentence=$2 code=0
    shift 2
    timeout 600 "$viewer" "$@" --screenshot "$work/none.png" >"$work/out" 2>&1 </dev/null || code=$?
    [ $code -eq "$wanted" ] || fail "$* ends with $code: $(cat "$work/out")"
    grep -qF -- "$sentence" "$work/out" || fail "$* says $(cat "$work/out")"
    [ ! -e "$work/none.png" ] || fail "$* leaves a picture"
}
# session SOURCE [MORE]: a session file that names it.
session() {
    printf '{"format": "spiraling-edge session", "version": 1, "input": {"source": "%s"}%s}' \
        "$1" "${2:-}" >"$work/a.sesession"
}

# The points of a pipe are there for a picture.
sphere 300 | "$viewer" - --goto 100% --screenshot "$work/stdin.png" || fail "no picture of standard input"
[ -s "$work/stdin.png" ] || fail "no picture of standard input"
refused 3 "standard input: is empty" -
echo "1 2 x" | "$viewer" - --screenshot "$work/none.png" 2>"$work/out" && fail "a malformed input is drawn"
grep -q "standard input:1" "$work/out" || grep -q "standard input" "$work/out" || fail "$(cat "$work/out")"

# Also in the window; reloading takes them from memory, and a session cannot refer to them.
mkfifo "$work/pipe"
sphere 300 >"$work/pipe" &
stdin=$work/pipe start -
says input "standard input"; says points 300; says pivot 0
press End; leaves pivot 0
press ctrl+r; says input "standard input"; says points 300; says pivot 0
press ctrl+s; says notice ".*came from standard input.*"
stop

# Sessions name regular files; numbers in them fit.
session /dev/zero
refused 3 '"input.source": expected a regular file' "$work/a.sesession"
session scene:sphere ', "compare": {"mesh": "/dev/zero"}'
refused 3 '"compare.mesh": expected a regular file' "$work/a.sesession"
ln -s /dev/zero "$work/zero.nrrd"
session sample:zero.nrrd,n=100
refused 3 '"input.source": expected a regular file' "$work/a.sesession"
printf 'NRRD0001\ntype: float\ndimension: 3\nsizes: 4 4 4\nencoding: raw\nendian: little\ndata file: zero.nrrd\n' >"$work/a.nhdr"
session sample:a.nhdr,n=100,iso=0
refused 3 "expected a regular file" "$work/a.sesession"
session sample:torus,n=100000000
refused 3 "n is from 1 to 10000000" "$work/a.sesession"
refused 3 "n is from 1 to 10000000" sample:torus,n=100000000
session scene:sphere ', "options": {"reach": 1e999}'
refused 3 '"options.reach": expected a number' "$work/a.sesession"
session scene:sphere ', "options": {"neighbors": 1e300}'
refused 3 '"options.neighbors"' "$work/a.sesession"
session scene:sphere ', "address": "99999999999.sphere.1"'
refused 3 '"address"' "$work/a.sesession"

# In the window a refused session changes nothing.
session /dev/zero
start scene:sphere; says phase ready
press ctrl+o; says file_browser true
type_text "$work/a.sesession"; press Return
says notice '.*a.sesession: .*'; says input scene:sphere; says phase ready
stop

# An input beyond the memory is an error message, not a crash.
(
    ulimit -v 3000000
    refused 3 "Out of memory." /dev/zero --most-bytes 100000000000
) || exit 1

# A tangled run: the first alerts, and a note about more.
start sample:torus,n=400 -r 5
says alert_search done; says alerts_complete false; says alerts "[1-9][0-9]*"
click_on "tab Alerts"; says open_tab Alerts
stop
well

# A given start is kept by a session.
echo '{"triangles": [[0, 2, 5], [0, 5, 6], [0, 6, 1]], "rings": [[0, 2, 5, 6, 1]]}' >"$work/start.json"
start scene:figure-3 --start "$work/start.json"
says phase ready; says triangles 3
press ctrl+s; says file_browser true
type_text "$work/begun"; press Return; says file_browser false
stop
grep -q '"start"' "$work/begun.sesession" || fail "the session forgets the start"
start "$work/begun.sesession"
says phase ready; says triangles 3
stop
