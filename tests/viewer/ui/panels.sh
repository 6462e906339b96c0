#!/usr/bin/env bash
# Every panel is opened, in three sizes of the window and at twice the scale; each is visible. Areas
# are resized by their splitters, folded, and remembered.
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

# every_group LEAST: the tabs of each group, where one column has them all.
every_group() {
    local name
    for name in "group Steps" "group Understand" "group Find" "group Change"; do
        click_on "$name"
        [ "$name" = "group Steps" ] && { says open_tab Steps; continue; }
        each_tab 3
        [ -z "$(field "more tabs")" ] || each_more
    done
}

# one_row: the tabs of no group need a second row or a list of those that do not fit.
one_row() {
    local name y h heights
    [ -z "$(field "more tabs")" ] || fail "a tab does not fit"
    heights=$(while IFS= read -r name; do
        read -r _ y _ h < <(field "$name" | tr -d '[],')
        echo "$y"
    done < <(grep -oE '"tab [^"]+"' "$state" | tr -d '"') | sort -u | wc -l)
    [ "$heights" -le 2 ] || fail "tabs in $heights rows"
}

# everything_inside WIDTH HEIGHT: no region leaves the window, and the view keeps its share.
everything_inside() {
    local name x y w h
    for name in view left dial right narration drawer find change; do
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
one_row
each_tab 14
one_row
everything_inside 1280 800
resize 1600 900
everything_inside 1600 900
one_row
resize 1024 640
everything_inside 1024 640
each_tab 14
one_row
says address "137\.sphere\.[0-9]+"
stop

# Splitters: an area follows its border, a double click resets it, and the settings keep it.
start scene:torus --goto 137.sphere
says address "137\.sphere\.[0-9]+"
press ctrl+p; type_text "rules"; press Return; says open_tab Rules
width_of() { local w; read -r _ _ w _ < <(field "region $1" | tr -d '[],'); echo "$w"; }
height_of() { local h; read -r _ _ _ h < <(field "region $1" | tr -d '[],'); echo "$h"; }
left=$(width_of left); lower=$(height_of find)
read -r x y < <(center "splitter left"); drag "$x" "$y" -40 0
[ "$(width_of left)" -eq $((left - 40)) ] || fail "left is $(width_of left), was $left"
read -r x y < <(inside "splitter lower" 30 50); drag "$x" "$y" 0 -30
[ "$(height_of find)" -eq $((lower + 30)) ] || fail "lower is $(height_of find), was $lower"
click_on "fold groups"; [ "$(height_of find)" -lt 60 ] || fail "Find does not fold"
click_on "tab Ledger"; [ "$(height_of find)" -eq $((lower + 30)) ] || fail "a tab does not unfold Find"
press ctrl+shift+j; [ "$(height_of find)" -lt 60 ] || fail "the key does not fold Find"
stop
start scene:torus --goto 137.sphere
says address "137\.sphere\.[0-9]+"
[ "$(width_of left)" -eq $((left - 40)) ] || fail "the width of left is forgotten"
[ "$(height_of find)" -lt 60 ] || fail "Find unfolds by itself"
click_on "tab Watch"; [ "$(height_of find)" -eq $((lower + 30)) ] || fail "the height is forgotten"
stop

size=1280x800 scale=2 start scene:torus --goto 137.sphere
says em 32.0
everything_inside 1280 800
every_group
stop
size=1024x640 theme=light start scene:torus --goto 137.sphere
says theme light
everything_inside 1024 640
stop
well
