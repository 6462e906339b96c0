#!/usr/bin/env bash
# From a scan to a saved mesh in three actions: Fix, Save mesh, Enter. And from a place with a fault to its reason
# in two: F8, W. On points of our own, and on scans of the folder with shared data where that is present.
. "$(dirname "$0")/harness.sh"
cli=$(dirname "$viewer")/spiraling-edge
[ -x "$cli" ] || { echo "skipped: no spiraling-edge beside the viewer"; exit 77; }
tests=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
bench=$tests/bench
shared=$tests/../../shared/data/points
cd "$work" || fail "no folder"

# variant NAME FILE VARIANT: the points of FILE made worse, as NAME.off.
variant() {
    "$cli" run "$2" --max-pivots 0 --normals -q -o base.off 2>/dev/null || fail "$2 cannot be read"
    mkdir -p made && python3 "$bench/scan_variants.py" base.off "$4" made || fail "no variants of $2"
    mv "made/$3.off" "$1.off"
}
# without_normals NAME.off: as NAME.xyz.
without_normals() { awk 'NR > 2 { print $1, $2, $3 }' "$1" >"${1%.off}.xyz"; }

# A sheet of uneven points with a hole that is one of the scan, and a noisy ball without normals.
awk 'BEGIN { for (y = 0; y < 20; ++y) for (x = 0; x < 20; ++x)
         if ((x - 10) ^ 2 + (y - 10) ^ 2 > 20) print x + 0.3 * sin(7 * x + 3 * y), y + 0.3 * sin(5 * x + 11 * y), 0, 0, 0, 1
     }' >sheet.xyz
python3 "$bench/sphere_ply.py" 2000 ball.ply || fail "no ball can be made"
variant ball ball.ply "rough 0.2" 0.06
without_normals ball.off
inputs=(sheet.xyz ball.xyz)
if [ -d "$shared" ]; then
    variant elephant "$shared/elephant.ply" half 0.02
    variant peaks "$shared/three_peaks.ply" "rough 0.1" 0.05
    variant knot "$shared/torus_knot.ply" "rough 0.2" 0.05
    without_normals knot.off
    inputs+=(elephant.off peaks.off knot.xyz)
else
    echo "skipped: no shared scans"
fi

for input in "${inputs[@]}"; do
    start "$input"; says alert_search done; says at_end true
    # Why is it there: the worst place, and its reason.
    if [ "$(field verdict)" != "the mesh is sound" ]; then
        press F8; says place 1
        press w; says open_tab Ledger
    fi
    says trials_ended true
    change=$(field trial_best)
    if [ -n "$change" ]; then
        verdict=$(field verdict)
        click_on "verdict fix"
        leaves verdict "$verdict"; says alert_search done; says at_end true
        says notice ".*The place that was shown .*"
        # The mesh of before, at the same camera, while the key is held; it has the same points.
        if [[ $change != *without* ]]; then
            xdotool keydown grave; says shown_state "earlier mesh"; picture "before-$input"
            xdotool keyup grave; says shown_state after
        fi
        picture "fixed-$input"
    fi
    press ctrl+e; says mesh_dialog true; says mesh_triangles '[1-9][0-9]*'; says typing true
    press Return; says mesh_dialog false
    stop
    saved=${input%.*}-mesh.ply
    [ -s "$saved" ] || fail "$input: nothing was saved as $saved"
    # Points that the best change drops are not in the file that the window saves.
    "$cli" run "$input" --best -q -o best.ply 2>/dev/null
    [[ $change == *without* ]] || cmp "$saved" best.ply || fail "$input: run --best writes another mesh"
    echo "$input: ${change:-no change is better}"
done

# An opening of the scan is closed up to a width, as the command line closes it.
start sheet.xyz; says alert_search done; says at_end true; says trials_ended true
verdict=$(field verdict)
click_on "verdict close holes"; says typing true
xdotool type 12; press Return; leaves verdict "$verdict"
says alert_search done; says at_end true
press ctrl+e; says mesh_dialog true; says mesh_triangles '[1-9][0-9]*'; says typing true
xdotool type closed.ply; press Return; says mesh_dialog false
stop
"$cli" run sheet.xyz --rules robust --rule holewidth=12 -q -o same.ply || fail "holewidth"
cmp closed.ply same.ply || fail "the window closes other holes than the command line"
well
