#include "panel_state/file_browser_state.h"

#include <doctest/doctest.h>

#include "lesson/lesson_player.h"
#include "open_session.h"

using namespace se::view;

TEST_CASE("The format of an export follows the name, and the name the format") {
    ExportForm form;
    form.followName("a.svg");
    CHECK(exportFormats()[form.format].extension == ".svg");
    form.followName("a.b");
    CHECK(exportFormats()[form.format].extension == ".svg");
    CHECK(form.withFormat("a.b") == "a.b.svg");
    CHECK(form.withFormat("a.GIF") == "a.GIF");
    std::string name = "a.svg";
    form.choose(0, name);
    CHECK(name == "a.png");
    name = "a.b";
    form.choose(1, name);
    CHECK(name == "a.b");
}

TEST_CASE("An export is ordered as the dialog has it, or refused with the reason") {
    ExportForm form;
    form.path = test::ownPlace("order.png").string();
    CHECK_FALSE(form.order("9.sphere.2").value().range);
    form.frames = ExportFrames::Pivot;
    CHECK(form.order("9.sphere.2").value().range->from == "9");
    CHECK(form.order("").error().message == "There is no pivot at the start of the run.");
    form.frames = ExportFrames::Range;
    CHECK(form.order("9").error().message == "Enter both positions of the range.");
    form.from = "3";
    form.to = "5";
    form.unit = PlayUnit::Pivot;
    CHECK(form.order("9").value().range->unit == PlayUnit::Pivot);
    for (const char* size : {"", "0x0", "1280", "99999x800", "1280x800x2"}) {
        form.size = size;
        CHECK_FALSE(form.order("9"));
    }
    form.size = "640x480";
    form.frames = ExportFrames::Lesson;
    CHECK(form.order("9").error().message == "No lesson is open.");
    const auto lesson = lessonOfSource("removal").value();
    CHECK(form.order("9", lesson).value().steps.empty());
    form.steps = "2,4-6";
    CHECK(form.order("9", lesson).value().steps == std::vector<std::size_t>{2, 4, 5, 6});
    form.steps = "99";
    CHECK(form.order("9", lesson).error().message.starts_with("99: expected steps from 1 to"));
    form.frames = ExportFrames::Picture;
    form.path = "/nowhere/a.png";
    CHECK_FALSE(form.order("9"));
    form.path = "a.xyz";
    CHECK(form.order("9").error().message.starts_with("a.xyz: expected a name"));
}

TEST_CASE("Captions and speed count only where the format has them") {
    ExportForm form;
    CHECK_FALSE(form.hasCaptions());
    form.frames = ExportFrames::Pivot;
    CHECK(form.hasCaptions());
    CHECK_FALSE(form.hasSpeed());
    form.frames = ExportFrames::Picture;
    form.captions = false;
    form.perSecond = "fast";
    form.path = test::ownPlace("look.png").string();
    CHECK(form.order("9").value().captions);
    form.followName("a.gif");
    CHECK(form.hasCaptions());
    CHECK(form.hasSpeed());
    form.path = test::ownPlace("look.gif").string();
    CHECK(form.order("9").error().message == "fast: expected frames per second, from 0.1 to 60");
    form.perSecond = "12.5";
    CHECK(form.order("9").value().perSecond == 12.5);
    CHECK_FALSE(form.order("9").value().captions);
}
