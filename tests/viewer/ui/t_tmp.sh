. /work/main/tests/viewer/ui/harness.sh
size=1600x900 theme=$THEME start scene:torus --goto 60.sphere.1
click_on "tab What if"
press f; says settled true
read -r x y < <(center "region view")
find_tested() {
    local dx dy
    for dy in 0 12 24 36 48 60 -12 -24; do
        for dx in 0 -12 -24 -36 -48 -60 -72 -84 -96 12 24 36 48; do
            click $((x + dx)) $((y + dy))
            [ "$(field selected)" = "$1" ] && { x=$((x + dx)); y=$((y + dy)); return 0; }
        done
    done
}
find_tested 414
move_to $x $y
act 1 xdotool mousedown 1
act 1 xdotool mousemove_relative -- -30 10
act 1 xdotool mousemove_relative -- -50 30
sleep 0.5; picture b; cp $work/b.png /tmp/b_$THEME.png
field drag_turns; field decision
cleanup
