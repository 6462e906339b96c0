#!/usr/bin/env bash
# Exports frames as a user or a script would, and opens them with other programs.
#   export_test.sh PROGRAM CASE    runs one case, in an empty folder of its own; exits with 77 (skipped)
#                                  where OpenGL or the other program is missing
set -uo pipefail
program=$(realpath "$1")
here=$(cd "$(dirname "$0")" && pwd)
. "$(dirname "$0")/../support/one_case.sh"
export XDG_CONFIG_HOME=$folder/config XDG_STATE_HOME=$folder/state

# expect CODE ARGUMENTS...: runs `spiraling-edge export`; its output is in `out` and `err` afterwards.
expect() {
    local wanted=$1 code=0
    shift
    "$program" export "$@" >out 2>err </dev/null || code=$?
    [ "$code" != 4 ] || [ "$wanted" = 4 ] || { echo "skipped: $(cat err)"; exit 77; }
    [ "$code" = "$wanted" ] || fail "\`spiraling-edge export $*\` ended with $code, not $wanted: $(cat err)"
}
says() { grep -qF -- "$2" "$1" || fail "'$2' is not in $1: $(head -c 2000 "$1")"; }
is() { [ "$1" = "$2" ] || fail "$3: $1, not $2"; }
needs() { command -v "$1" >/dev/null || { echo "skipped: $1 is not installed"; exit 77; }; }
files() { find "$1" -type f | wc -l; }
# alike A B [SHARE]: less than this share of the pixels differ visibly, 3 percent.
alike() {
    local pixels off
    pixels=$(identify -format '%[fx:w*h]' "$1")
    off=$(compare -metric AE -fuzz 10% "$1" "$2" null: 2>&1)
    awk "BEGIN { exit !($off < ${3:-0.03} * $pixels) }" || fail "$off of $pixels pixels of $1 and $2 differ"
}

one_picture_has_the_size_and_the_look() {
    needs identify
    expect 0 scene:figure-8 --goto 9.sphere.2 -o a.png --size 640x400 --scale 1.5
    is "$(identify -format '%wx%h %[channels]' a.png)" "960x600 srgb" "the picture"
    expect 0 scene:figure-8 --goto 9.sphere.2 -o b.png --size 640x400 --background none
    is "$(identify -format '%wx%h %[channels]' b.png)" "640x400 srgba" "without a background"
    expect 0 scene:figure-8 --goto 9.sphere.2 -o c.png --size 640x400 --theme light --labels off
    cmp -s a.png c.png && fail "theme and labels have no effect"
    is "$(files .)" 5 "files"
}

a_range_has_one_camera_and_captions() {
    needs compare
    expect 0 scene:figure-8 --from 9.sphere.1 --to 9.emit.4 -o frames/ --size 640x400
    is "$(find frames -name '*.png' | wc -l)" 8 "frames"
    is "$(wc -l <frames/captions.txt)" 8 "captions"
    says frames/captions.txt "$(printf '002.png\t9.sphere.2\tPoint q lies 0.26303 outside')"
    # What no decision changes is at the same place.
    alike frames/005.png frames/006.png
    alike frames/007.png frames/008.png
    expect 0 scene:figure-8 --around 9 -o p.png --captions off --size 320x240
    [ -s p-001.png ] && [ -s p-026.png ] || fail "no numbered files: $(ls)"
    [ ! -e p-captions.txt ] || fail "captions in spite of off"
    expect 0 scene:figure-8 --from 0 --to 5 --unit pivot -o q.png --size 320x240
    is "$(find . -name 'q-*.png' | wc -l)" 6 "ends of pivots"
    # If each had a camera of its own, they would differ in a fifth of their pixels.
    expect 0 scene:figure-8 --from 20 --to 25 --unit pivot -o r/ --labels off --size 640x400
    alike r/003.png r/004.png 0.1
}

a_lesson_is_exported_step_by_step() {
    expect 0 removal -o steps/ --steps 1,3-4 --size 320x240
    is "$(find steps -name '*.png' | wc -l)" 3 "steps"
    expect 0 removal -o all.svg --size 320x240
    is "$(find . -name 'all-*.svg' | wc -l)" 10 "steps of the whole lesson"
    says steps/captions.txt "Four candidates: "
    expect 2 removal -o x.png --steps 40
    says err "expected steps from 1 to"
    expect 2 removal -o x.png --goto 5
    says err "a lesson has --steps"
    printf '# A\n```se lesson\nversion = 1\ninput = "scene:figure-8"\n```\n## B\nText.\n```se step\nat = "9.sphere.7"\n```\n' >a.lesson.md
    expect 3 a.lesson.md -o x.png
    says err "a.lesson.md:9: at: "
    sed 's/sphere.7/sphere.2/' a.lesson.md >c.lesson.md
    expect 0 c.lesson.md -o own/ --size 320x240
    says own/captions.txt "$(printf '001.png\t9.sphere.2\tB: Point q lies')"
    sed "s/^at = .*/&\ncamera = '{\"camera\": {}}'/" c.lesson.md >d.lesson.md
    expect 3 d.lesson.md -o x.png
    says err "camera: expected a position with its address"
    printf '# A\n' >b.lesson.md
    expect 3 b.lesson.md -o x.png
    says err "b.lesson.md"
    [ ! -e x.png ] || fail "a file in spite of the error"
}

a_step_with_compare_shows_both_runs() {
    needs convert
    needs rsvg-convert
    # Step 9 compares, step 8 asks.
    expect 0 spiral -o a/ --steps 9 --size 1024x768
    says a/captions.txt "A, paper rules: The next pivot is 2. B, sphere off: The next pivot is 2."
    convert a/001.png -crop 512x768 +repage half-%d.png
    [ "$(compare -metric AE -fuzz 10% half-0.png half-1.png null: 2>&1)" -gt 5000 ] || fail "both halves show the same"
    expect 0 spiral -o b.svg --steps 9 --size 1024x768
    for part in 'id="view-a"' 'id="view-b"' '>sphere off</text>' 'id="view-b-labels"' 'width="1024"'; do
        says b-001.svg "$part"
    done
    # The stripes of the new triangles, which fill much of this step, have softer edges in a drawing.
    rsvg-convert b-001.svg -o b.png && convert a/001.png -blur 0x3 even-a.png && convert b.png -blur 0x3 even-b.png &&
        alike even-a.png even-b.png
    expect 0 spiral -o c.html --steps 8-9
    is "$(grep -c 'id="s2-view-b"' c.html)" 1 "drawings of the second run"
    expect 0 spiral -o d.gif --steps 7-9 --size 640x480
    is "$(identify d.gif | wc -l)" 3 "frames"
}

# probe FIELD FILE: of the first video stream or the container, as ffprobe finds it.
probe() { ffprobe -v error -count_frames -show_entries stream=nb_read_frames,width,height:format=duration -of default=nw=1 "$2" | sed -n "s/^$1=//p"; }

an_animation_has_its_frames() {
    needs ffprobe
    for name in a.gif a.mp4; do
        expect 0 scene:figure-8 --from 9.sphere.1 --to 9.emit.4 -o $name --size 641x401 --fps 4
        is "$(probe nb_read_frames $name)" 8 "frames of $name"
        is "$(probe duration $name)" 2.000000 "duration of $name"
    done
    is "$(probe width a.gif)x$(probe height a.gif)" 641x401 "size of a.gif"
    is "$(probe width a.mp4)x$(probe height a.mp4)" 642x402 "even size of a.mp4"
    needs compare
    expect 0 scene:figure-8 --goto 9.emit.2 -o b.png --place '{"address": "9.emit.2"}'
    expect 0 scene:figure-8 --goto 9.emit.2 -o b.gif --captions off --place '{"address": "9.emit.2"}'
    convert 'b.gif[0]' b2.png
    alike b.png b2.png
    expect 2 scene:figure-8 --around 9 -o b.gif --background none
    says err "no transparent background"
}

a_video_says_what_it_needs() {
    mkdir fake
    echo old >a.mp4
    PATH=$PWD/fake expect 2 scene:figure-8 --around 9 -o a.mp4
    says err "needs ffmpeg (apt-get install ffmpeg); .gif and .html need nothing"
    printf '#!/bin/sh\nhead -c 100000 >/dev/null\necho "out of luck" >&2\nexit 1\n' >fake/ffmpeg
    chmod +x fake/ffmpeg
    PATH=$PWD/fake:$PATH expect 5 scene:figure-8 --around 9 -o a.mp4
    says err "a.mp4: ffmpeg ended early: out of luck"
    is "$(cat a.mp4)" old "the old file"
}

# seconds COMMAND...: of the processor.
seconds() {
    local TIMEFORMAT='%U %S'
    { time "$@" >/dev/null 2>&1; } 2>&1 | awk '{ print $1 + $2 }'
}

many_frames_cost_less_than_many_processes() {
    expect 0 scene:figure-8 --goto 9 -o a.png
    local one all
    one=$(seconds "$program" export scene:figure-8 --goto 9 -o a.png)
    all=$(seconds "$program" export scene:figure-8 --around 9 -o frames/)
    is "$(find frames -name '*.png' | wc -l)" 26 "frames"
    echo "26 frames: $all s of the processor; one: $one s"
    awk "BEGIN { exit !($all < 26 * $one / 2) }" || fail "26 frames cost $all s, one costs $one s"
}

an_interrupted_export_leaves_the_old_file() {
    expect 0 scene:figure-8 --goto 9 -o a.gif --size 320x240
    echo old >a.gif
    local signal work code
    for signal in TERM INT; do
        env --default-signal=INT "$program" export scene:torus --from 1 --to 60 -o a.gif >/dev/null 2>&1 &
        work=$!
        sleep 1.5
        kill -$signal $work 2>/dev/null || fail "it ended before"
        code=0
        wait $work || code=$?
        is "$code" "$([ $signal = INT ] && echo 130 || echo 143)" "exit code after SIG$signal"
        is "$(cat a.gif)" old "the old file"
        is "$(find . -name '.*' -type f | wc -l)" 0 "parts of files"
    done
}

# dom FILE: the page once its scripts have run.
dom() {
    timeout 100 chromium --headless --no-sandbox --disable-gpu --window-size=1400,900 \
        --host-resolver-rules='MAP * ~NOTFOUND' --virtual-time-budget=4000 --dump-dom "file://$PWD/$1" 2>/dev/null
}

a_page_is_one_file_of_a_lesson() {
    expect 0 removal -o p.html
    is "$(grep -c '<section class="step"' p.html)" 10 "steps"
    is "$(grep -c '<form class="ask">' p.html)" 5 "questions"
    cp "$here/../../assets/lessons/one-pivot.lesson.md" mine.lesson.md
    expect 0 mine.lesson.md -o mine.html
    is "$(grep -c '<section class="step"' mine.html)" 10 "steps of a file, on a pivot to practice"
    [ "$(wc -c <p.html)" -lt 800000 ] || fail "$(wc -c <p.html) bytes for 10 steps"
    ! grep -qE '(src|href)="(http|//|file)' p.html || fail "the page loads something"
    [ "$(sed -n '/^"use strict"/,$p' p.html | wc -c)" -lt 30000 ] || fail "the script is long"
    says p.html ".view{fill:#e8eaed}"
    says p.html ".view{fill:#1e2126}"
    printf '# A <b> & "c"\n```se lesson\nversion = 1\ninput = "scene:figure-8"\n```\n## <script>x</script>\n<i>T</i> [a](javascript:x)\n' >a.lesson.md
    expect 0 a.lesson.md -o a.html
    ! grep -qE '<script>x|<i>|href="javascript' a.html || fail "a lesson's text is markup"
    expect 3 b.lesson.md -o a.html
    expect 0 scene:figure-8 --from 9.sphere.1 --to 9.sphere.4 -o r.html --captions off
    is "$(grep -c '<section class="step"' r.html)" 4 "frames"
    is "$(grep -c '<figcaption>' r.html)" 0 "captions in spite of off"
}

a_page_is_answered_in_a_browser() {
    needs chromium
    expect 0 removal -o p.html
    # Keys, a click at a point of the picture, the check, and the file that is saved.
    cat >>p.html <<'JS'
<script>
window.addEventListener("load", () => {
  const said = [];
  const key = (name) => document.dispatchEvent(new KeyboardEvent("keydown", { key: name, bubbles: true }));
  const now = () => document.querySelector(".step.now");
  said.push(document.querySelectorAll(".step.now").length, location.hash);
  key("PageDown"); said.push(location.hash, now().dataset.title);
  const click = (point) => {
    const box = now().querySelector('.before [data-point="' + point + '"]').getBoundingClientRect();
    const at = { clientX: (box.left + box.right) / 2, clientY: (box.top + box.bottom) / 2, bubbles: true };
    now().querySelector(".before svg").dispatchEvent(new MouseEvent("click", at));
  };
  click(31);
  said.push(now().querySelector(".answer").value);
  now().querySelector("[type=submit]").click();
  said.push(now().querySelector(".says").textContent);
  click(31); click(46);
  now().querySelector("[type=submit]").click();
  said.push(now().querySelector(".says").textContent, now().querySelector(".after").hidden);
  URL.createObjectURL = (blob) => { blob.text().then((text) => { document.body.dataset.result = text; }); return "#2"; };
  document.getElementById("save").click();
  key("End"); said.push(location.hash); key("ArrowLeft"); said.push(location.hash);
  document.body.dataset.said = said.join("|");
});
</script>
JS
    dom p.html >dom.html
    python3 - <<'PYTHON' || fail "the page cannot be read"
import html, re
dom = open("dom.html").read()
field = lambda name: html.unescape(re.search('data-%s="([^"]*)"' % name, dom).group(1))
open("said", "w").write(field("said"))
open("a.result.json", "w").write(field("result"))
PYTHON
    says said "1||#2|Which of them go?|s|Not right. Not in the answer: s. Missing: 1."
    says said "|Right. The answer is q."
    says said "|false|#10|#9"
    "$program" lesson results a.result.json >table || fail "the program does not read the result"
    says table "100 %"
    says table "s (1)"
}

wrong_orders_are_refused_before_any_work() {
    expect 2 scene:figure-8 -o x.jpg
    says err "expected a name that ends in .png"
    expect 2 scene:figure-8 -o x.png --size 0x0
    says err "--size"
    expect 2 scene:figure-8 -o x.png --from 9
    expect 2 scene:figure-8 -o x.png --goto 9 --around 9
    expect 2 scene:figure-8 -o x.png --from 10 --to 9
    says err "9 is before 10"
    expect 2 scene:figure-8 -o x.png --from 9.sphere.9 --to 10
    says err "pivot 9 has 4 decisions of sphere, not 9"
    expect 2 scene:figure-8 -o nowhere/x.png
    expect 2 scene:figure-8 -o ./
    says err "a folder is for several frames"
    expect 2 scene:figure-8 --steps 1 -o x.png
    says err "--steps is for lessons"
    expect 3 missing.ply -o x.png
    is "$(files .)" 2 "files (out and err)"
}

a_drawing_looks_as_the_picture() {
    needs rsvg-convert
    needs compare
    local scene at
    for scene in figure-8:9.sphere.2 figure-12:35.split.1 torus:50% sphere:100%; do
        at=${scene#*:}
        for theme in dark light; do
            expect 0 "scene:${scene%:*}" --goto "$at" --theme $theme -o a.svg
            expect 0 "scene:${scene%:*}" --goto "$at" --theme $theme -o a.png
            rsvg-convert a.svg -o b.png || fail "rsvg-convert refuses the drawing of $scene"
            # Hatching is a tone: its lines need not be at the same pixels.
            for picture in a b; do convert $picture.png -blur 0x2 $picture-tones.png; done
            alike a-tones.png b-tones.png 0.01
        done
    done
}

a_drawing_has_layers_text_and_points() {
    expect 0 scene:figure-8 --goto 9.sphere.2 -o a.svg
    for part in 'id="triangles"' 'id="edge-ring"' 'id="circumsphere-of-a-test"' 'id="labels"' \
        'data-point="46"' '>first</text>' '.used{fill:#56b4e9}' '<title>Point q lies 0.26303'; do
        says a.svg "$part"
    done
    expect 0 scene:figure-8 --goto 9.sphere.2 -o b.svg --captions off --labels off --background none
    ! grep -qE '<title>|<text|class="view"' b.svg || fail "captions, labels or background"
}

the_dial_stands_beside_the_view() {
    expect 0 scene:figure-8 --goto 9.sphere.2 -o a.svg --dial on
    for part in 'id="dial"' '>Tangent plane at p</text>' '>gap 53.4' 'id="labels"'; do
        says a.svg "$part"
    done
    expect 0 scene:figure-8 --goto 9.sphere.2 -o b.svg
    ! grep -q 'id="dial"' b.svg || fail "the dial, unasked"
    needs compare
    expect 0 scene:figure-8 --goto 9.sphere.2 -o a.png --dial on
    expect 0 scene:figure-8 --goto 9.sphere.2 -o b.png
    [ "$(compare -metric AE -fuzz 10% a.png b.png null: 2>&1)" -gt 20000 ] || fail "no dial in the picture"
}

the_old_file_stays_if_the_new_one_fails() {
    ln -s /dev/full full.png
    expect 5 scene:figure-8 --goto 9 -o full.png --size 320x240
    says err "full.png"
    echo old >a.png
    expect 2 scene:figure-8 --goto 9.sphere.9 -o a.png
    is "$(cat a.png)" old "the old file"
}

addresses_of_a_page_lead_to_the_program() {
    expect 0 scene:figure-8 --rules robust --goto 9.sphere.2 -o a.html --viewer https://example.org/se/
    says a.html '<a href="https://example.org/se/#scene=figure-8&amp;rules=robust&amp;goto=9.sphere.2"'
    expect 0 scene:figure-8 --goto 9.sphere.2 -o a.html
    ! grep -q 'href="[^#]' a.html || fail "links, unasked"
    printf '# A\n```se lesson\nversion = 1\ninput = "scene:figure-8"\n```\n## B\nText, [so](se:9.sphere.3).\n```se step\nat = "9.sphere.2"\n```\n' >a.lesson.md
    expect 0 a.lesson.md -o b.html --viewer ../viewer.html
    says b.html 'href="../viewer.html#scene=figure-8&amp;goto=9.sphere.2"'
    says b.html 'href="../viewer.html#scene=figure-8&amp;goto=9.sphere.3"'
    "$program" sample sphere -n 2000 -q -o many.ply
    expect 0 many.ply --goto 9 -o c.html --viewer https://example.org/se/
    says err "addresses of many.ply are no links: its points are too many for a link"
    ! grep -q 'example.org' c.html || fail "a link to a file that is not there"
    local wrong
    for wrong in 'javascript:alert(1)' 'https://a b/' 'a"b' 'ftp://example.org/' 'a.html#x'; do
        expect 2 scene:figure-8 --goto 9 -o a.html --viewer "$wrong"
        says err "expected the address of a page"
    done
    expect 2 scene:figure-8 --goto 9 -o a.png --viewer https://example.org/
    says err "--viewer: is for pages"
}

the_program_is_a_page_with_content() {
    expect 2 scene:torus --app -o a.png
    says err "expected a name that ends in .html"
    expect 2 removal --app -o a.html --steps 2
    says err "--steps: is for frames"
    expect 2 scene:torus --app -o a.html --viewer https://example.org/
    says err "--viewer: is for pages of frames"
    expect 2 removal --app -o a.html --goto 5
    says err "a lesson has --step"
    # Programs of a folder of their own: without the page, and with it.
    mkdir bin
    cp "$program" "$(dirname "$program")/spiraling-edge-viewer" bin/
    program=$PWD/bin/spiraling-edge
    expect 4 removal --app -o a.html
    says err "app/web/build.sh makes it"
    printf '<meta name="start" content="">\n<title>Spiraling Edge</title>\n' >bin/spiraling-edge.html
    expect 0 removal --app -o a.html
    says a.html '<meta name="start" content="lesson=removal">'
    expect 0 scene:torus --rules robust --goto 137.sphere.3 --app -o a.html
    says a.html 'content="scene=torus&amp;rules=robust&amp;goto=137.sphere.3"'
    "$program" sample sphere -n 200 -q -o points.ply
    expect 0 points.ply --app -o a.html --alert first
    says a.html 'content="file=points.ply&amp;alert=first"'
    says a.html '<script type="text/plain" data-file="points.ply">'
    expect 3 missing.ply --app -o b.html
    expect 2 removal --app -o bin/spiraling-edge.html
    says err "--force"
    echo old >bin/spiraling-edge.html
    expect 4 removal --app -o b.html
    says err "it is no page of this version"
    [ ! -e b.html ] || fail "a page in spite of the error"
}

grep -qx "$2() {" "$here/export_test.sh" || fail "there is no case $2"
[ "$failed" = 1 ] || "$2"
[ "$failed" = 0 ] && echo "ok: $2"
exit "$failed"
