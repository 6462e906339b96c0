#!/usr/bin/env bash
# The dialog Export: formats, frames, the file that is there already, progress and Cancel. The picture
# equals that of the command line.
. "$(dirname "$0")/harness.sh"
cli=$(dirname "$viewer")/spiraling-edge
out="$work/my pictures"
mkdir "$out"
cd "$out" || fail "no folder"
enter() { says typing true; press Return; }

# This picture: a name is proposed; the window stays as it is.
start scene:figure-8 --goto 9.sphere.2 --focus; says phase ready; says address '9\.sphere\.2'
press ctrl+shift+e; says export_dialog true; says mesh_name 'figure-8-9-sphere-2\.png'
enter; says export_dialog false; says message 'Saved a frame as .*figure-8-9-sphere-2\.png\.'
says address '9\.sphere\.2'
[ "$(identify -format '%wx%h' figure-8-9-sphere-2.png)" = 1280x800 ] || fail "the picture has another size"
if [ -x "$cli" ]; then
    # The same session, saved and exported by the command line, is the same picture.
    press ctrl+s; says file_browser true; says typing true; type_text "$work/a.sesession"; press Return; says file_browser false
    "$cli" export "$work/a.sesession" -o "$work/cli.png" || fail "the command line fails"
    [ "$(compare -metric AE "$work/cli.png" figure-8-9-sphere-2.png null: 2>&1)" = 0 ] || fail "the command line makes another picture"
fi

# The second time it is replaced only on request; a format changes the name.
echo old >figure-8-9-sphere-2.png
press ctrl+shift+e; says export_dialog true; says mesh_name 'figure-8-9-sphere-2\.png'
enter; says export_question '.*exists already.*'
[ "$(cat figure-8-9-sphere-2.png)" = old ] || fail "the file was replaced without an answer"
enter; says export_dialog false
[ "$(head -c 4 figure-8-9-sphere-2.png | tail -c 3)" = PNG ] || fail "the file was not replaced"

# All frames of a pivot, as an animation, with the window alive meanwhile.
press ctrl+shift+e; says export_dialog true
click_on "export gif"; says mesh_name 'figure-8-9-sphere-2\.gif'; says export_format '\.gif'
click_on "export this pivot"
enter; says export_dialog false; says message 'Saved 26 frames as .*\.gif\.'
[ "$(identify figure-8-9-sphere-2.gif | wc -l)" = 26 ] || fail "the animation has other frames"

# A wrong range is refused in the dialog; Cancel leaves no file.
press ctrl+shift+e; says export_dialog true
click_on "export html"; click_on "export range"
click_on "export from"; type_text 10; click_on "export to"; type_text 9
click_on "export go"; says export_complaint '9 is before 10'; says export_working false
click_on "export to"; press ctrl+a; type_text 40
click_on "export go"; says export_working true; says export_made '[1-9][0-9]*'
click_on "export cancel"; says export_working false; says export_complaint 'Cancelled\.'
[ "$(ls | wc -l)" = 2 ] || fail "an export that was cancelled left a file: $(ls)"
press Escape; says export_dialog false
stop

# Steps of the open lesson, at another speed, without captions; fields only where they count.
rm ./*.gif
start lesson:removal --step 3; says lesson_step 3; says address '9\.sphere\.2'
press ctrl+shift+e; says export_dialog true
for field in speed captions steps; do denies "export $field" '.+'; done
click_on "export gif"; click_on "export lesson"
click_on "export steps"; type_text "1,3"; click_on "export speed"; press ctrl+a; type_text 0
click_on "export go"; says export_complaint '0: expected frames per second, from 0\.1 to 60'
click_on "export speed"; press ctrl+a; type_text 4; click_on "export captions"
click_on "export go"; says export_dialog false; says message 'Saved 2 frames as .*\.gif\.'
says lesson_step 3; says address '9\.sphere\.2'
[ "$(identify -format '%T ' ./*9-sphere-2.gif)" = "25 25 " ] || fail "the speed is another: $(identify -format '%T ' ./*.gif)"
stop
well
