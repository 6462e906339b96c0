# Drives the real window under a virtual display as a user would, and reads the visible state of the
# program. To be sourced by a scenario, a script that is called with the path of the viewer:
#
#   . "$(dirname "$0")/harness.sh"
#   start scene:sphere            # opens the window; size=1024x640 scale=2 theme=light start ...
#                                 # instead of 1280x800, scale 1, dark; size=kept for the last size
#   press F10; says pivot 1       # keys; a field of the state, as a regular expression
#   click 480 300                 # in pixels of the window
#   stop                          # Ctrl+Q, and a good exit code
#
# Exits with 0 on success, 77 (skipped) if a tool is missing, and reports the state on failure.
set -u
viewer=$(realpath "$1")
# The same program, which writes its state.
driven=$(dirname "$viewer")/driven-viewer
[ -x "$driven" ] || { echo "FAILED: $driven is not built"; exit 1; }
for tool in Xvfb xdotool compare import; do
    command -v "$tool" >/dev/null || { echo "skipped: $tool is not installed"; exit 77; }
done

work=$(mktemp -d)
mkfifo "$work/silence"
exec 7<>"$work/silence"
# rest: a moment, without another process.
rest() { read -rt "$pause" -u 7 || true; }
server=
program=
window=
export SPIRALING_EDGE_STATE=$work/state.json
state=$SPIRALING_EDGE_STATE
cleanup() {
    [ -n "$program" ] && kill "$program" 2>/dev/null
    [ -n "$server" ] && kill "$server" 2>/dev/null
    rm -rf "$work"
}
trap cleanup EXIT
fail() {
    echo "FAILED: $*" >&2
    [ -f "$state" ] && cat "$state" >&2
    [ -f "$work/program.log" ] && tail -n 20 "$work/program.log" >&2
    exit 1
}

# A separate display of SIZE (1700x1000); the program finds an empty home.
display() {
    mkfifo "$work/number"
    Xvfb -displayfd 3 -screen 0 "${1:-1700x1000}x24" -nolisten tcp -noreset 3>"$work/number" 2>/dev/null &
    server=$!
    local number
    read -r -t 20 number <"$work/number" || fail "Xvfb does not start"
    export DISPLAY=:$number
    unset WAYLAND_DISPLAY
    export HOME=$work/home XDG_CONFIG_HOME=$work/config XDG_STATE_HOME=$work/state XDG_CACHE_HOME=$work/cache
    mkdir -p "$HOME" "$XDG_CONFIG_HOME" "$XDG_STATE_HOME" "$XDG_CACHE_HOME"
}

# start OPTION...: opens the window, and waits for it.
start() {
    [ -n "$server" ] || display
    rm -f "$state"
    local sized=(--size "${size:-1280x800}")
    [ "${size:-}" != kept ] || sized=()
    "$driven" "${sized[@]}" --ui-scale "${scale:-1}" --theme "${theme:-dark}" "$@" <"${stdin:-/dev/null}" >"$work/program.log" 2>&1 &
    program=$!
    window=
    for _ in $(seq $looks); do
        kill -0 "$program" 2>/dev/null || fail "the program ends at once"
        window=$(xdotool search --onlyvisible --name "Spiraling Edge" 2>/dev/null | head -n 1)
        [ -n "$window" ] && [ -f "$state" ] && break
        rest
    done
    [ -n "$window" ] || fail "no window appears"
    xdotool windowfocus --sync "$window"
}

# stop: Ctrl+Q; the program quits with exit code 0.
# Settings that the script has changed are not kept.
stop() {
    press ctrl+q
    for _ in $(seq $looks); do
        kill -0 "$program" 2>/dev/null || break
        if matches asks true; then click_on "leave discard"; fi
        rest
    done
    kill -0 "$program" 2>/dev/null && fail "Ctrl+Q does not quit"
    wait "$program"
    local code=$?
    program=
    [ $code -eq 0 ] || fail "the exit code is $code"
}

# Waiting is for states, however long they take: a busy machine is slow, not wrong. After this many
# looks the state does not come.
looks=2400
pause=0.05
# poll COMMAND...: calls it until it succeeds. Fails at the end, or when the program is gone.
poll() {
    local look
    for ((look = 0; look < looks; ++look)); do
        "$@" && return 0
        kill -0 "$program" 2>/dev/null || { "$@"; return; }
        rest
    done
    return 1
}
settled_after() {
    look_up input_events
    [ "${value:-0}" -ge "$1" ] && look_up settled && [ "$value" = true ]
}
# act EVENTS COMMAND...: what the user does, which makes at least EVENTS events (press and release
# are two); waits until the program has handled and drawn them.
act() {
    local events=$(($(field input_events) + $1))
    shift
    "$@"
    poll settled_after "$events" || true
}
press() {
    local chord
    for chord in "$@"; do act 2 xdotool key --clearmodifiers "$chord"; done
}
type_text() { act $((2 * ${#1})) xdotool type --delay 25 -- "$1"; }
go_to() { press ctrl+g; type_text "$1"; press Return; }
pointer() { xdotool getmouselocation | cut -d' ' -f1,2; }
move_to() {
    local X=0 Y=0
    eval "$(xdotool getwindowgeometry --shell "$window" | grep -oE '\b[XY]=-?[0-9]+')"
    [ "$(pointer)" = "x:$((X + $1)) y:$((Y + $2))" ] ||
        act 1 xdotool mousemove --window "$window" "$1" "$2"
}
click() {
    local button=${3:-1}
    move_to "$1" "$2"
    act $((button < 4 ? 2 : 1)) xdotool click "$button"  # a step of the wheel is one event
    # In the view it selects once no second click can follow.
    poll matches click_waits false
}
# drag X Y BY_X BY_Y [BUTTON]
drag() {
    move_to "$1" "$2"
    act 1 xdotool mousedown "${5:-1}"
    act 1 xdotool mousemove_relative -- "$(($3 / 2))" "$(($4 / 2))"
    act 1 xdotool mousemove_relative -- "$(($3 - $3 / 2))" "$(($4 - $4 / 2))"
    act 1 xdotool mouseup "${5:-1}"
}
# resize WIDTH HEIGHT: and waits until the program has drawn itself at that width.
is_wide() {
    local w
    read -r _ _ w _ < <(field "region strip" | tr -d '[],')
    [ "${w:-0}" -eq "$1" ]
}
resize() {
    act 1 xdotool windowsize --sync "$window" "$1" "$2"
    poll is_wide "$1"
}

# look_up NAME: its current value in the state, without quotes, in `value`; lists on one line.
look_up() {
    local pattern='(\[[^]]*\]|\{[^}]*\}|"[^"]*"|[^[:space:],}]+)' text=
    value=
    read -rd '' text 2>/dev/null <"$state" || true
    [[ $text =~ .*\"$1\":\ $pattern ]] || return 0
    value=${BASH_REMATCH[1]//$'\n'/ }
    while [[ $value == *"  "* ]]; do value=${value//  / }; done
    value=${value#\"}
    value=${value%\"}
}
# field NAME: prints it.
field() {
    look_up "$1"
    [ -z "$value" ] || printf '%s\n' "$value"
}
matches() { look_up "$1" && [[ $value =~ ^($2)$ ]]; }
differs() { look_up "$1" && [ "$value" != "$2" ]; }
# says NAME PATTERN: waits until the field matches.
says() {
    poll matches "$1" "$2" && return 0
    kill -0 "$program" 2>/dev/null || fail "the program is gone while waiting for $1: $2"
    fail "expected $1: $2, found '$(field "$1")'"
}
# leaves NAME VALUE: waits until the field has another value.
leaves() { poll differs "$1" "$2" || fail "$1 stays $2"; }
# denies NAME PATTERN: the current value does not match.
denies() {
    poll settled_after 0
    [[ $(field "$1") =~ ^($2)$ ]] && fail "$1 is $2"
    return 0
}
# inside NAME PERCENT_X PERCENT_Y: "X Y", that position within an item that the program has drawn,
# e.g. "part Dial"; center NAME: its middle.
inside() {
    local x y w h place before=
    # In the first frames parts have no size yet, and parts and lists move to their positions.
    for _ in $(seq 200); do
        poll settled_after 0
        place=$(field "$1" | tr -d '[],')
        read -r x y w h <<<"$place"
        [ "${w:-0}" -gt 0 ] && [ "$place" = "$before" ] && break
        before=$place
        rest
    done
    [ -n "${h:-}" ] || fail "nothing is drawn that is called '$1'"
    echo "$((x + w * $2 / 100)) $((y + h * $3 / 100))"
}
center() { inside "$1" 50 50; }
# click_on NAME [BUTTON]
click_on() {
    local x y
    read -r x y < <(center "$1") || exit 1
    click "$x" "$y" "${2:-1}"
}
title() { xdotool getwindowname "$window" 2>/dev/null; }

# A Python that can talk to the display server (Debian: python3-xlib); empty if there is none.
xlib_python=
for python in python3 /usr/bin/python3; do
    "$python" -c 'import Xlib' 2>/dev/null && { xlib_python=$python; break; }
done

# picture NAME; differing A B: number of pixels that differ.
picture() { import -window "$window" "$work/$1.png" || fail "cannot read the window"; }
differing() {
    local count
    count=$(compare -metric AE -fuzz "${3:-5%}" "$work/$1.png" "$work/$2.png" null: 2>&1)
    count=${count%%[!0-9]*}
    echo "${count:-0}"
}
well() { echo "all is well"; }
