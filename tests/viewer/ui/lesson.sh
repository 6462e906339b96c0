#!/usr/bin/env bash
# A lesson as a student goes through it: from the start page, step by step, a question answered wrong
# and right, the result saved; then as a teacher does: bookmarks become a lesson, the file is edited
# while it is open.
. "$(dirname "$0")/harness.sh"

# The tour: one click on the start page, and from Help.
start
click_on "tile lesson:tour"
says lesson "Ninety seconds on a torus"; says task Lesson; says address 1.seed.1
says lesson_step 1; says question none; says task Lesson
click_on "lesson next"; says address 1.sort.12; says lesson_step 2
press Next; says address 1.sphere.1
# A link leads away, the button back.
click_on "link se:1.sphere.2"; says address 1.sphere.2; says lesson_away true
click_on "lesson return"; says address 1.sphere.1; says lesson_away false
press Prior; says lesson_step 2
press ctrl+p; type_text "close the lesson"; press Return; says lesson ""
stop

# A question: marks by click, the keys of the run end at the question.
start lesson:spiral --result "$work/mine.result.json" --step 2
says question open; says address 1.sort.12
press F11; press End; says address 1.sort.12
press ctrl+p; type_text "charts"; press Return; says notice "Answer the question first, or show its answer."
press Escape
read -r x y < <(center "lesson answer field")
click "$x" "$y"; type_text "3, 4, 99"; says given "3, 4, 99"
press ctrl+a; type_text "3, 4, 8"; says marked 3; says answered_right ""
click_on "lesson answer"; says answered_right false; says tries 1; says question open
click_on "lesson answer field"; press ctrl+a; type_text "3, 4, 5, 6, 7"; press Return
says answered_right true; says tries 2; says question shown
says right_answer "3, 4, 5, 6, 7"
# The decisions up to the answer are played.
says address 1.sphere.11
grep -q '"right": true' "$work/mine.result.json" || fail "the result is not saved"
grep -q '"tries": 2' "$work/mine.result.json" || fail "the tries are not counted"
stop

# A teacher: two bookmarks become a lesson; the open file is read again when it changes.
start scene:figure-8
says address 9.sphere.2
press ctrl+b; press F11 F11; press ctrl+b; says bookmarks '.*9.sphere.2.*9.sphere.4.*'
press ctrl+p; type_text "save as lesson"; press Return; says file_browser true
press ctrl+a; type_text "$work/mine.lesson.md"; press Return
says notice "Saved .*mine.lesson.md."
press ctrl+o; type_text "$work/mine.lesson.md"; press Return
says asks true; click_on "leave discard"
says lesson "A lesson on scene:figure-8"; says lesson_step 1; says address 9.sphere.2
press Next; says lesson_step 2; says address 9.sphere.4
sed -i 's/## 9.sphere.4/## After the change/' "$work/mine.lesson.md"
says lesson_title "After the change"; says lesson_step 2
# A faulty lesson: its first fault is told, and the one before stays.
sed -i 's/9.sphere.4/9.sphere.44/' "$work/mine.lesson.md"
says lesson_complaint ".*mine.lesson.md:[0-9]+: at: pivot 9 has 4 decisions of sphere, not 44.*"
says lesson_title "After the change"
stop
well
