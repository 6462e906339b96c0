#!/usr/bin/env bash
# Every panel is opened, in three sizes of the window and at twice the scale; each is visible.
. "$(dirname "$0")/harness.sh"

# each_tab LEAST: opens every visible tab; each changes the picture.
each_tab() {
    local name seen=0
    # In the first frames they have no position yet.
    poll grep -q '"tab ' "$state"
    while IFS= read -r name; do
        # If there is no room for all, another one may have replaced it.
        [ -n "$(field "$name")" ] || continue
        click_on "$name"
        says open_tab "${name#tab }"
        seen=$((seen + 1))
    done < <(grep -oE '"tab [^"]+"' "$state" | tr -d '"')
    [ "$seen" -ge "$1" ] || fail "only $seen tabs"
}

# each_more: tabs that do not fit into the rows are opened from the list at their end, each by its
# name; then it has a name in the rows.
each_more() {
    local name
    click_on "more tabs"
    grep -oE '"more [A-Z][^"]*"' "$state" | tr -d '"' | sed 's/^more //' >"$work/more"
    [ -s "$work/more" ] || fail "no panel is in the list"
    press Escape
    while IFS= read -r name; do
        # Opening another one may have made room for it.
        [ -n "$(field "tab $name")" ] || { click_on "more tabs"; click_on "more $name"; }
        [ "$(field open_tab)" = "$name" ] || click_on "tab $name"
        says open_tab "$name"
        inside "tab $name" 50 50 >/dev/null
    done <"$work/more"
}

# everything_inside WIDTH HEIGHT: no region leaves the window, and the view keeps its share.
everything_inside() {
    local name x y w h
    for name in view left dial right narration drawer; do
        read -r x y w h < <(field "region $name" | tr -d '[],')
        [ "$w" -eq 0 ] || [ "$h" -eq 0 ] || { [ $((x + w)) -le "$1" ] && [ $((y + h)) -le "$2" ]; } ||
            fail "$name leaves the window: $x $y $w $h"
    done
    read -r x y w h < <(field "region view" | tr -d '[],')
    [ $((100 * w)) -ge $((39 * $1)) ] || fail "the view is $w of $1 wide"
    [ "$h" -ge 150 ] || fail "the view is $h high"
}

start scene:torus --goto 137.sphere
says address "137\.sphere\.[0-9]+"
everything_inside 1280 800
each_tab 3
resize 1600 900
everything_inside 1600 900
resize 1024 640
everything_inside 1024 640
each_tab 15
says address "137\.sphere\.[0-9]+"
stop

size=1280x800 scale=2 start scene:torus --goto 137.sphere
says em 32.0
everything_inside 1280 800
each_tab 8
each_more
stop
size=1024x640 theme=light start scene:torus --goto 137.sphere
says theme light
everything_inside 1024 640
stop
well
