#!/usr/bin/env bash
# A rule is switched during a run: the cursor stays by state, undo and the session file record
# it. A fork at a test, and the way back.
. "$(dirname "$0")/harness.sh"

# reach NAME: scrolls the group Change until the item can be clicked, and clicks it.
reach() {
    local x y top high h
    read -r x y < <(inside "region change" 85 60)
    for _ in $(seq 40); do
        read -r _ top _ high < <(field "region change" | tr -d '[],')
        read -r _ h < <(center "$1")
        [ "$h" -gt $((top + 50)) ] && [ "$h" -lt $((top + high - 20)) ] && { click_on "$1"; return; }
        click "$x" "$y" "$([ "$h" -le $((top + 50)) ] && echo 4 || echo 5)"
    done
    fail "$1 does not come into sight"
}

size=1600x980 start scene:torus --goto 60.sphere.1
says pivot 60
says choices '\[\]'
address=$(field address)
press ctrl+p; type_text "rules switches"; press Return
says open_tab Rules
[ -n "$(field "effect tie")" ] || fail "a rule has no sentence in its row"

# The filter finds the rule; a switch re-runs, and a second click undoes it.
click_on "rules filter"; type_text "walls passed"
click_on "rule walls"
says choices '\[ "walls=off" \]'; says phase ready
says address "$address" # there are no walls here
says message "Same place: no difference before it\..*"
click_on "reset walls"
says choices '\[\]'

# A rule with an effect: the same pivot at its new position, or the last shared state.
click_on "rules filter"; press ctrl+a; type_text "maxgap"
click_on "rule maxgap"; press ctrl+a; type_text "95"; press Return
says choices '\[ "maxgap=95" \]'; says phase ready
says message "(Same (place|pivot).*runs diverge at pivot [0-9]+\.|The new run has no pivot.*)( Now .*)?"
press Escape; press ctrl+z; says choices '\[\]'; says message "Undone: rule maxgap\..*"
press ctrl+y; says choices '\[ "maxgap=95" \]'

# The session file keeps it.
press ctrl+s; says file_browser true
type_text "$work/rules"; press Return; says session_file ".*rules.sesession"
click_on "rules reset all"; says choices '\[\]'
stop
size=1600x980 start "$work/rules.sesession"
says choices '\[ "maxgap=95" \]'
stop

# A fork: a removed point is kept.
size=1600x980 start scene:torus --goto 60.sphere.1
says pivot 60
press ctrl+p; type_text "what if forks"; press Return
says open_tab "What if"
for _ in $(seq 40); do
    [ -n "$(field "what if here")" ] && break
    press F11
done
address=$(field address)
click_on "what if here"
says what_if '\[ "[0-9]+\.[a-z]+ (keep|drop) [0-9]+" \]'; says phase ready
says address "$address"
press Escape; press ctrl+z; says what_if '\[\]'; says message "Undone: what-if\..*"
press ctrl+y; says what_if '\[ "[0-9]+\.[a-z]+ (keep|drop) [0-9]+" \]'
click_on "true run"; says what_if '\[\]'; says phase ready
says address "$address"
# A what-if against a triangle.
go_to 60.emit.1; says address "60\.emit\.1"
click_on "what if here"
says what_if '\[ "60\.guard drop [0-9]+" \]'; says phase ready
click_on "true run"; says what_if '\[\]'; says phase ready
# Refused, with the reason: a point in its own list.
reach "what if list"; press ctrl+a; type_text "1 1"
reach "what if neighbors"
says message ".*is refused\. Point 1 is in the list twice\..*"
says what_if '\[\]'
stop
well
