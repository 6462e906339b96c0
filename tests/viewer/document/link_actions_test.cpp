#include "document/link_actions.h"

#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "commands/commands.h"
#include "document/link.h"
#include "headless_app.h"
#include "run/packed_file.h"
#include "session/view_position.h"
#include "spiraling_edge/spec/spec_fields.h"

using namespace se;
using namespace se::view;

namespace {

struct LinkApp : test::HeadlessApp {
    explicit LinkApp(const char* name = "link-test") : test::HeadlessApp(name) {}

    void run(const char* command) {
        runCommand(*findCommand(command), context);
        settle();
    }
    void settle() {
        lesson.waitUntilDone();
        waitUntilDone();
        lesson.poll();
        waitUntilDone();
        // As Application does with a newly opened input.
        if (const auto pose = document.takeCamera()) camera.setPose(*pose);
    }
    void paste(const std::string& text) {
        ui.clipboard.copy(text);
        run("step.paste");
    }
    void goTo(const char* address) {
        REQUIRE(session.moves().goToText(address).ok());
        settle();
    }
    std::string place() { return session.event() ? toString(session.address()) : "0"; }
    std::string copied() { return ui.clipboard.copied(); }
    std::string write(const std::string& name, const std::string& text) {
        std::ofstream(folder / name) << text;
        return (folder / name).string();
    }
};

/// Points of a plane.
std::string grid(int side) {
    std::string text;
    for (int x = 0; x < side; ++x) {
        for (int y = 0; y < side; ++y)
            text += std::to_string(x) + " " + std::to_string(y) + " 0 0 0 1\n";
    }
    return text;
}

CameraPose roundedPose() {
    CameraPose pose;
    pose.target = {0.125F, -0.25F, 0.5F};
    pose.distance = 1.5F;
    pose.yawDegrees = 33.5F;
    pose.pitchDegrees = 12.25F;
    pose.orthographic = true;
    return pose;
}

}  // namespace

TEST_CASE("Copy link, then Ctrl+V, restores address and camera without opening again") {
    LinkApp app;
    app.openInstead("scene:torus");
    app.goTo("12.sort.2");
    app.camera.setPose(roundedPose());
    app.run("step.copy");
    CHECK(
        app.copied().starts_with("spiraling-edge.html#scene=torus&goto=12.sort.2&"
                                 "camera=0.125,-0.25,0.5,1.5,33.5,12.25,orthographic&hash="));
    CHECK(app.session.messages().notice() == "Link copied.");
    const std::uint32_t generation = app.session.generation();
    app.goTo("50");
    app.camera.set(ViewPreset::Top);
    app.run("step.paste");
    CHECK(app.place() == "12.sort.2");
    CHECK(app.camera.pose() == roundedPose());
    CHECK(app.session.generation() == generation);
}

TEST_CASE("A link to another input, or by other rules, opens it at its place") {
    LinkApp app;
    app.openInstead("scene:torus");
    app.document.run(changed({"scene:torus"}, specChange({{"rules", "robust"}})));
    app.settle();
    app.goTo("12.sort.2");
    app.camera.setPose(roundedPose());
    app.run("step.copy");
    const std::string link = app.copied();
    CHECK(link.find("&rules=robust") != std::string::npos);
    for (const char* other : {"scene:sphere", "scene:torus"}) {
        CAPTURE(other);
        LinkApp reader("link-reader");
        reader.openInstead(other);
        reader.paste(link);
        CHECK(reader.session.input().spec() == app.session.input().spec());
        CHECK(reader.place() == "12.sort.2");
        CHECK(reader.camera.pose() == roundedPose());
    }
}

TEST_CASE("A link from a run that ends otherwise says so, and one from this run does not") {
    const std::string sentence =
        "The link is from another version of the program or of the points: there the run ends "
        "differently, and its addresses may refer to other decisions.";
    LinkApp app;
    app.openInstead("scene:torus");
    app.run("step.copy");
    const std::string link = app.copied();
    const auto noticeOf = [](const std::string& text) {
        LinkApp reader("link-hash");
        reader.openInstead("scene:sphere");
        reader.paste(text);
        reader.document.poll();
        reader.document.poll();
        return reader.session.messages().notice();
    };
    CHECK(noticeOf(link) != sentence);
    CHECK(noticeOf(link.substr(0, link.size() - 16) + "0123456789abcdef") == sentence);
    app.paste(link.substr(0, link.size() - 16) + "0123456789abcdef");
    app.document.poll();
    app.document.poll();
    CHECK(app.session.messages().notice() == sentence);
}

TEST_CASE("A link to the open input takes its looks, and moves only to a place that it names") {
    LinkApp app;
    app.openInstead("scene:torus");
    app.goTo("12.sort.2");
    app.paste("#scene=torus&theme=light&mesh-style=wire&layout=present");
    CHECK(app.place() == "12.sort.2");
    CHECK(app.ui.settings.theme == Theme::Light);
    CHECK(app.ui.settings.meshStyle == MeshStyle::Wire);
    CHECK(app.ui.layoutPreset == LayoutPreset::Present);
}

TEST_CASE("A link with a camera alone moves the camera alone") {
    LinkApp app;
    app.openInstead("scene:torus");
    app.goTo("12.sort.2");
    app.paste("#scene=torus&camera=0.125,-0.25,0.5,1.5,33.5,12.25,orthographic");
    CHECK(app.place() == "12.sort.2");
    CHECK(app.camera.pose() == roundedPose());
}

TEST_CASE("A run by other rules than those of the link may end differently, without a warning") {
    LinkApp app;
    app.openInstead("scene:sphere");
    app.paste("#scene=torus&hash=0123456789abcdef");
    app.document.run(changed({"scene:torus"}, specChange({{"rules", "robust"}})));
    app.settle();
    app.document.poll();
    app.document.poll();
    CHECK(app.session.messages().notice().find("differently") == std::string::npos);
}

TEST_CASE("A copied frame is HTML with the link in it") {
    LinkApp app;
    app.openInstead("scene:torus");
    app.goTo("12.sort.2");
    app.run("step.copyframe");
    CHECK(app.copied().starts_with(
        "<iframe src=\"spiraling-edge.html#scene=torus&amp;goto=12.sort.2&amp;"));
    CHECK(app.copied().ends_with("</iframe>"));
}

TEST_CASE("Ctrl+V still reads an address and the text of earlier versions") {
    LinkApp app;
    app.openInstead("scene:torus");
    app.paste(toText(ViewPosition{"12.sort.2", roundedPose()}));
    CHECK(app.place() == "12.sort.2");
    CHECK(app.camera.pose() == roundedPose());
    app.paste(" 20 ");
    CHECK(app.place().starts_with("20."));
    app.paste("#scene=torus&gto=3");
    CHECK(app.session.messages().notice() == "\"gto\" is no part of a link: did you mean goto?");
    CHECK(app.place().starts_with("20."));
}

TEST_CASE("A small file is inside the copied link, a larger one is named") {
    LinkApp app;
    app.openInstead(app.write("small.xyz", grid(6)));
    app.goTo("7");
    const std::string place = app.place();
    app.run("step.copy");
    const std::string link = app.copied();
    CHECK(link.starts_with("spiraling-edge.html#pack=small.xyz:"));
    CHECK(link.size() < 8000);
    CHECK(link.find(app.folder.string()) == std::string::npos);
    const std::uint32_t generation = app.session.generation();
    app.goTo("9");
    app.run("step.paste");
    CHECK(app.place() == place);
    CHECK(app.session.generation() == generation);
    {
        LinkApp reader("link-reader");
        reader.paste(link);
        REQUIRE(reader.session.ready());
        CHECK(reader.session.model().name == "small.xyz");
        CHECK(reader.session.model().points.size() == 36);
        CHECK(reader.session.model().hash == app.session.model().hash);
        CHECK(reader.place() == place);
        reader.run("step.copy");
        CHECK(reader.copied() == link);
    }
    std::string large;
    for (int i = 0; i < 6000; ++i)
        large +=
            std::to_string(i * 7919 % 10007) + " " + std::to_string(i * 104729 % 9973) + " 0\n";
    app.openInstead(app.write("large.xyz", large));
    app.run("step.copy");
    CHECK(app.copied().starts_with("spiraling-edge.html#file=large.xyz&"));
    CHECK(app.session.messages().notice() ==
          "Link copied. The link names the file large.xyz but does not contain it.");
}

TEST_CASE("A link to a step of a lesson opens that step") {
    LinkApp app;
    app.document.open("lesson:tour");
    app.settle();
    app.lesson.toStep(2);
    app.settle();
    app.run("step.copy");
    CHECK(app.copied().starts_with("spiraling-edge.html#lesson=tour&step=3"));
    LinkApp reader("link-reader");
    reader.openInstead("scene:sphere");
    reader.settle();
    reader.paste(app.copied());
    REQUIRE(reader.ui.lesson.walk.isOpen());
    CHECK(reader.ui.lesson.walk.source() == "lesson:tour");
    CHECK(reader.ui.lesson.walk.step() == 2);
    reader.paste("#lesson=tour&step=2");
    CHECK(reader.ui.lesson.walk.step() == 1);
}

TEST_CASE("A damaged packed file is reported, and the open input stays") {
    LinkApp app;
    app.openInstead("scene:torus");
    const std::string source = packedSource({"a.xyz", grid(6)});
    app.paste("#" + std::string("pack=") + source.substr(5, source.size() - 9));
    CHECK(app.session.messages().notice().find("damaged") != std::string::npos);
    CHECK(app.session.input().spec().source == "scene:torus");
}
