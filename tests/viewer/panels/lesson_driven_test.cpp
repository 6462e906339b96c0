/// Lessons and the layout Present as they are seen and used.
#include <doctest/doctest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "driven_app.h"
#include "open_session.h"
#include "state_dump.h"

using namespace se;
using namespace se::view;
using test::differing;
using test::DrivenApp;

namespace {

/// All of the visible state but times and counts of frames.
std::string lastingState(DrivenApp& app) {
    auto state = nlohmann::json::parse(test::stateDump(app.app));
    for (const char* name :
         {"first_frame_seconds", "first_window_seconds", "longest_opening_seconds", "motions"}) {
        state.erase(name);
    }
    return state.dump();
}

}  // namespace

TEST_CASE("With a question open neither the state nor the picture tells of what follows") {
    const test::OwnFolder folder;
    const std::string path = (folder / "same.lesson.md").string();
    std::string state;
    Picture picture;
    // Two lessons whose runs part after the question.
    for (const char* rule : {"", "rule = [\"sphere=off\"]\n"}) {
        std::ofstream(path) << "# One of two runs\n```se lesson\nversion = 1\n"
                               "input = \"scene:figure-2\"\n"
                            << rule
                            << "```\n## Which stay?\nMark them.\n```se ask\nat = \"1.sort.12\"\n"
                               "until = \"1.advance.1\"\nkind = \"number\"\n"
                               "answer = \"count:enter\"\n```\n";
        DrivenApp app({path});
        if (!app) return;
        CHECK(app["question"] == "open");
        CHECK(app.address() == "1.sort.12");
        if (!state.empty()) {
            CHECK(lastingState(app) == state);
            CHECK(app.picture().rgba == picture.rgba);
        }
        state = lastingState(app);
        picture = app.picture();
    }
}

TEST_CASE("The second run of a step that compares has the names of the lesson") {
    const test::OwnFolder folder;
    const std::string path = (folder / "names.lesson.md").string();
    std::ofstream(path)
        << "# Names\n```se lesson\nversion = 1\ninput = \"scene:torus\"\n"
           "names = { here = 0, there = 534 }\n```\n## Two runs\nBeside each other.\n"
           "```se step\nat = \"1.sphere.1\"\ncompare = \"--rule next=start\"\n```\n";
    DrivenApp app({path});
    if (!app) return;
    CHECK(app["layout"] == "compare");
    CHECK(app["decision"].find("there") != std::string::npos);
    CHECK(app["other_decision"].find("there") != std::string::npos);
}

TEST_CASE("A question is answered by keys, and the button Answer keeps its place") {
    DrivenApp app({"lesson:removal", "--step", "6"});
    if (!app) return;
    app.press("A");
    CHECK(app["given"] == "A");
    const glm::vec2 place = app.in("lesson answer");
    app.press("Enter");
    CHECK(app["answered_right"] == "false");
    CHECK(app.in("lesson answer") == place);
    app.press("B Enter");
    CHECK(app["answered_right"] == "true");
    CHECK(app["question"] == "shown");
}

TEST_CASE("Present shows the address, blanks the screen by its keys, and dims by its spotlight") {
    DrivenApp app({"scene:sphere", "--goto", "40.sort.1", "--layout", "present"});
    if (!app) return;
    CHECK(app["address_line"] == "40.sort.1 \xC2\xB7 6.1");
    app.press("PageDown");
    CHECK(app["address_line"] == "40.sort.2 \xC2\xB7 6.1");
    app.press("PageUp");
    // A key shows the window again, and does nothing else.
    for (const char* key : {"B", ".", "W"}) {
        app.press(key);
        CHECK(app["blank"] == "true");
        app.press("PageDown");
        CHECK(app["blank"] == "false");
        CHECK(app.address() == "40.sort.1");
    }
    const Picture plain = app.picture();
    app.press("L");
    CHECK(differing(plain, app.picture()) > 20000);
    app.press("L");
    CHECK(differing(plain, app.picture()) < 200);
    app.press("Shift+F5");
    CHECK(app["layout"] == "present");
    app.press("F5");
    CHECK(app["address_line"] == "start");
    CHECK(app["pivot_arrow"] == "false");
}

TEST_CASE("In Present an open question has the keys of its answers, and F5 returns to it") {
    DrivenApp app({"lesson:removal", "--step", "6", "--layout", "present"});
    if (!app) return;
    const std::string asked = app.address();
    app.press("Left F5");
    CHECK(app.address() == asked);
    app.press("B");
    CHECK(app["blank"] == "false");
    CHECK(app["given"] == "B");
    app.press("Enter");
    CHECK(app["answered_right"] == "true");
    // Also once it is answered, whose decisions are shown from there.
    app.press("Home");
    CHECK(app.session.atStart());
    app.press("F5");
    CHECK_FALSE(app.session.atStart());
    app.press("B");
    CHECK(app["blank"] == "true");
}

TEST_CASE("In Present the caption begins a lesson with its introduction, and all of it fits") {
    const test::OwnFolder folder;
    const std::string path = (folder / "introduced.lesson.md").string();
    const auto heightWith = [&](const std::string& introduction) {
        std::ofstream(path)
            << "# A lesson\n```se lesson\nversion = 1\ninput = \"scene:torus\"\n```\n"
            << introduction
            << "\n## The first step\nOne line.\n```se step\nat = \"1.sort.1\"\n```\n";
        DrivenApp app({path, "--layout", "present"});
        return app ? app.ui.where.at("lesson caption").size.y : 0.0F;
    };
    const float without = heightWith("");
    if (without == 0.0F) return;
    CHECK(heightWith("What it is about.") > without);
    for (const char* lesson : {"removal", "tour", "spiral", "class"}) {
        CAPTURE(lesson);
        DrivenApp app({std::string("lesson:") + lesson, "--step", "1", "--layout", "present"});
        const Rect area = app.app.areas().narration;
        CHECK(app.ui.where.at("lesson caption").max().y < area.max().y);
        CHECK(area.size.y <= 0.4F * 800.0F);
    }
}

TEST_CASE("In Present a question has its options on one line, and the caption no empty half") {
    DrivenApp app({"lesson:removal", "--step", "2", "--layout", "present"});
    if (!app) return;
    const auto caption = [&] { return app.ui.where.at("lesson caption"); };
    const float asked = caption().size.y;
    const float area = app.app.areas().narration.size.y;
    CHECK(area < 0.4F * 800.0F);
    CHECK(caption().size.y > 0.8F * area);
    // The grade is on the line of the options, so the view keeps its size.
    app.press("B Enter");
    CHECK(app["answered_right"] == "false");
    CHECK(caption().size.y == asked);
    app.press("A Enter");
    CHECK(app["answered_right"] == "true");
    CHECK(caption().size.y == asked);
    CHECK(app.app.areas().narration.size.y == area);
}

TEST_CASE("On a phone every question shows its answer field or first option above the way on") {
    for (const char* lesson : {"removal", "neighbor-ring", "one-pivot"}) {
        DrivenApp app({std::string("lesson:") + lesson, "--step", "1"}, {390, 844});
        if (!app) return;
        const LessonWalk& walk = app.ui.lesson.walk;
        for (std::size_t step = 1; step < walk.lesson().steps.size(); ++step) {
            app.press("PageDown");
            if (!walk.asks()) continue;
            CAPTURE(walk.source());
            CAPTURE(walk.step() + 1);
            const Rect back = app.ui.where.at("lesson previous");
            const bool typed = app.shows("lesson answer field");
            CHECK(app.ui.where.at(typed ? "lesson answer field" : "option A").max().y < back.min.y);
            CHECK(back.max().y <= 844.0F);
        }
    }
}

TEST_CASE(
    "An arrow leads to a pivot outside of the view, in every layout, and stays while stepping") {
    DrivenApp app({"scene:sphere", "--goto", "40.sphere.1", "--layout", "present"});
    if (!app) return;
    const auto away = [&] {
        for (int i = 0; i < 5; ++i) app.drag(app.in("region view", 0.7F, 0.3F), {-500, 60}, 1);
        CHECK(app["pivot_arrow"] == "true");
    };
    app.press("F");
    CHECK(app["pivot_arrow"] == "false");
    app.press("Shift+V");
    away();
    const CameraPose pose = app.pose();
    app.press("F11 F11 F10");
    CHECK(app.pose() == pose);
    CHECK(app["pivot_arrow"] == "true");
    const Rect arrow = app.ui.where.at("pivot arrow");
    const Rect view = app.ui.where.at("region view");
    CHECK(arrow.min.x >= view.min.x);
    CHECK(arrow.min.y >= view.min.y);
    CHECK(arrow.max().x <= view.max().x);
    CHECK(arrow.max().y <= view.max().y);
    app.clickOn("pivot arrow");
    CHECK(app["pivot_arrow"] == "false");
    CHECK(app.session.selected() == kNone);
    for (const char* layout : {"debug", "present"}) {
        app.press("F2");
        CHECK(app["layout"] == layout);
        CHECK(app["address_line"].empty() == (app["layout"] == "debug"));
        away();
        app.clickOn("pivot arrow");
        CHECK(app["pivot_arrow"] == "false");
    }
}
