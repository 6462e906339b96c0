#!/usr/bin/env bash
# New points: a shape is chosen, the particles spread visibly, are paused, stepped, saved and used.
. "$(dirname "$0")/harness.sh"

# larger A B: A > B, with decimals.
larger() { awk -v a="$1" -v b="$2" 'BEGIN { exit !(a > b) }'; }

start
says start_page true
click_on "start file.new.shape"
says growth_page true; says start_page '.*'
# They spread visibly, 30 steps per second; on a busy machine a second try may be needed.
seen=no
for _ in 1 2 3 4 5; do
    for _ in $(seq 400); do
        step=$(field growth_step)
        [ "$(field growth)" = done ] && break
        [ "$(field growth)" = spreading ] && [ "${step:-0}" -gt 0 ] && [ "$step" -lt 150 ] && seen=yes && break
        sleep 0.02
    done
    [ $seen = yes ] && break
    press Home
done
[ $seen = yes ] || fail "their spreading is not shown"
# While paused, a step changes the picture.
press Home space; says growth paused
step=$(field growth_step)
[ "$step" -lt 160 ] || fail "paused at step $step"
first=$(field growth_variation)
picture one
press Right; says growth_step $((step + 1)); says growth paused
press F10; says growth_step $((step + 2))
picture two
[ "$(differing one two)" -gt 200 ] || fail "a step moves nothing in the view"
says growth_points 2000
# Keys of a run have no effect here, those of the view have.
layers=$(field layers)
press n m; [ "$(field layers)" = "$layers" ] || fail "keys of the run work under the page"
press 1; says yaw '.*'
drag 700 300 60 20

# Another shape, clipped by walls; all steps at once.
click_on "shape gyroid"
says growth_source "sample:gyroid.*"
press End; says growth done; says growth_step 160
larger "$(field growth_walls)" 50 || fail "no points on walls"
larger 0.10 "$(field growth_variation)" || fail "the variation is $(field growth_variation)"
larger 0.0001 "$(field growth_off)" || fail "off by $(field growth_off)"

# A number typed; Enter starts with it, also in the next field without input.
click_on "shape torus"; says growth_source "sample:torus.*"
read -r x y < <(inside "field Points" 50 50); click "$x" "$y"
type_text "700"; press Tab; press Return
says growth_points 700
read -r x y < <(inside "field Points" 50 50); click "$x" "$y"
type_text "600"; press Return
says growth_points 600
press End; says growth done
larger "$first" "$(field growth_variation)" || fail "they did not become more even"

# Saved, they are byte for byte those of the command line.
click_on "growth save"; says file_browser true
type_text "$work/torus"; press Return
says file_browser false; says growth_message "Saved .*torus\.ply\."
cli=$(dirname "$viewer")/spiraling-edge
if [ -x "$cli" ]; then
    "$cli" sample torus -n 600 -q -o "$work/cli.ply" || fail "the command line does not sample"
    cmp "$work/torus.ply" "$work/cli.ply" || fail "the points differ from those of the command line"
fi

# Errors are reported, and the page stays.
read -r x y < <(inside "field Isovalue" 50 50); click "$x" "$y"
type_text "1000"; press Return
says growth failed; says growth_complaint ".*no surface.*"
click_on "shape torus"; says growth_points 600; press End; says growth done

# Used, they are an ordinary run; the title identifies them.
click_on "growth use"
says growth_page false; says phase ready
says input "torus, 600.* points"; says points 600
press F10; says pivot 1; press F10; says pivot 2
title | grep -q "torus, 600" || fail "the title is $(title)"

# A session of them keeps the line that makes them; the page leads back to the run.
press ctrl+s; says file_browser true
type_text "$work/grown"; press Return; says file_browser false
grep -q '"source": "sample:torus,n=600"' "$work/grown.sesession" || fail "the session names another source"
press ctrl+n; says growth_page true; says growth "spreading|done"
press Escape; says growth_page false; says pivot 2; says points 600
stop
start "$work/grown.sesession"; says phase ready; says points 600; says pivot 2; stop
# They are among the recent files as well, after their session.
start; says recent 2; click_on "recent 2"; says input "torus, 600.* points"; says points 600; stop
# Scattering millions of particles does not block.
start --new sphere -n 5000000; says growth finding; stop

# From the command line, also a volume; a truncated one is reported in core's words.
printf 'NRRD0004\ntype: uint8\ndimension: 3\nsizes: 9 9 9\nencoding: raw\n\n' >"$work/ball.nrrd"
awk 'BEGIN { for (k = -4; k < 5; k++) for (j = -4; j < 5; j++) for (i = -4; i < 5; i++) {
    v = 100 - 5 * (i * i + j * j + k * k); printf "%03o ", (v > 0 ? v : 0) } }' |
    tr ' ' '\n' | while read -r byte; do printf '%b' "\\0$byte"; done >>"$work/ball.nrrd"
start --new "$work/ball.nrrd" -n 300; says growth failed; says growth_complaint ".*has no isovalue.*"; stop
start --new "$work/ball.nrrd" --iso 50 -n 300 --steps 12
says growth paused; says growth_step 12; says growth_points 300
press space; says growth done; stop
# From a run, the path of a volume is typed at once.
start scene:sphere; says phase ready
press ctrl+shift+n; says file_browser true
type_text "$work/ball.nrrd"; press Return; says file_browser false; says growth_complaint ".*has no isovalue.*"
press Escape; says growth_page false; says phase ready; stop
head -c 300 "$work/ball.nrrd" >"$work/cut.nrrd"
start --new "$work/cut.nrrd" --iso 50; says growth failed; says growth_complaint ".*cut\.nrrd.*expected.*"
press Escape; says growth_page false; says start_page true; stop
well
