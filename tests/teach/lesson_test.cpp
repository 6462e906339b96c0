#include "teach/lesson.h"

#include <doctest/doctest.h>

#include "lesson_files.h"
#include "teach/lesson_read.h"
#include "teach/lesson_text.h"

namespace se::teach {

TEST_CASE("a step goes on where the one before ended") {
    const LessonReading reading = readLesson(
        lessonWith("## Text\n\n" + stepWith("step", "at = \"9.limits.2\"\nuntil = \"9.sphere.1\"") +
                   "## More\n\n" +
                   stepWith("step", "input = \"scene:grid\"\nrule = \"sphere=off\"") + "## End\n"),
        "x");
    REQUIRE(reading.ok());
    const Lesson& lesson = reading.lesson;
    CHECK(settingOf(lesson, 0).at == "9.sphere.2");  // where the scene opens
    CHECK(settingOf(lesson, 1).at == "9.limits.2");
    CHECK(settingOf(lesson, 1).answerPlace == "9.sphere.1");
    CHECK(settingOf(lesson, 2).at == "9.sphere.1");
    CHECK(settingOf(lesson, 3).input == "scene:grid");
    CHECK(settingOf(lesson, 3).at == "4.sphere.5");
    CHECK(settingOf(lesson, 3).run == specChange({{"switches", "sphere=off"}}));
    CHECK(settingOf(lesson, 4).input == "scene:grid");
    CHECK(settingOf(lesson, 4).run.empty());
}

TEST_CASE("names and view are those of the figure unless the lesson gives others") {
    const Lesson lesson =
        readLesson(lessonWith("## S\n\n" + stepWith("step", "view = \"left\"") +
                              stepWith("step", "input = \"scene:torus\"\nnames = { a = 3 }")),
                   "x")
            .lesson;
    const StepSetting first = settingOf(lesson, 0);
    CHECK(pointOf("q", first.names) == 46);
    CHECK(pointOf("12", first.names) == 12);
    CHECK(pointOf("x", first.names) == kNone);
    CHECK(pointsText({46, 7}, first.names) == "q, 7");
    CHECK(viewDirection(first) == Vec3(0.0, 0.0, 1.0));
    CHECK(viewDirection(settingOf(lesson, 1)) == Vec3(-1.0, 0.0, 0.0));
    const StepSetting torus = settingOf(lesson, 2);
    CHECK(torus.names == std::vector<PointName>{{3, "a"}});
    CHECK_FALSE(viewDirection(torus).has_value());
}

TEST_CASE("text is split into blocks with styles and links") {
    const std::vector<TextBlock> blocks = textBlocks(
        "One *two* **three** `four` [five](se:1.seed.1).\n\n3. first\n4. second\n\n> said\n\n"
        "![alt](a.png)\n\n```\ncode\n```\n\n<b>html</b>\n");
    REQUIRE(blocks.size() >= 6);
    CHECK(blocks[0].kind == TextBlockKind::Paragraph);
    CHECK(blocks[0].spans[1].text == "two");
    CHECK(blocks[0].spans[1].emphasized);
    CHECK(blocks[0].spans[3].strong);
    CHECK(blocks[0].spans[5].code);
    CHECK(blocks[0].spans[7].link == "se:1.seed.1");
    CHECK(blocks[0].spans[8].link.empty());
    CHECK(blocks[1].number == 3);
    CHECK(blocks[2].number == 4);
    CHECK(blocks[3].kind == TextBlockKind::Quote);
    CHECK(plainTextOf(textBlocks("a\nb\n\n- c\n")) == "a b\n- c\n");
}

}  // namespace se::teach
