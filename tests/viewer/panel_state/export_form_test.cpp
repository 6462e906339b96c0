#include "panel_state/export_form.h"

#include <doctest/doctest.h>

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
    form.unit = FrameUnit::Pivot;
    CHECK(form.order("9").value().range->unit == FrameUnit::Pivot);
    for (const char* size : {"", "0x0", "1280", "99999x800", "1280x800x2"}) {
        form.size = size;
        CHECK_FALSE(form.order("9"));
    }
    form.size = "640x480";
    form.path = "/nowhere/a.png";
    CHECK_FALSE(form.order("9"));
    form.path = "a.xyz";
    CHECK(form.order("9").error().message.starts_with("a.xyz: expected a name"));
}
