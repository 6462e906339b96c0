/// The panels of the group Find, the part with the verdict and the pins, as the mouse reaches them.
#include <doctest/doctest.h>
#include <imgui.h>

#include <cstdlib>

#include "document/alert_actions.h"
#include "driven_app.h"
#include "jobs/questions.h"
#include "open_session.h"
#include "point_files.h"
#include "spiraling_edge/run/event_text.h"

using namespace se;
using namespace se::view;
using test::differing;
using test::DrivenApp;

TEST_CASE("Alerts: clicks lead to the moments of one, and F8 frames its place") {
    DrivenApp app({"scene:four-edge-hole"}, {1600, 980});
    if (!app) return;
    CHECK(app["task"] == "Step");
    app.part("Alerts");
    app.reach("region column", "alert created");
    CHECK(app.address().starts_with("54.emit."));
    CHECK_FALSE(app.session.noticedHere().empty());
    app.reach("region column", "alert decided");
    CHECK(app.address() == "54.sphere.1");
    app.reach("region column", "alert first touched");
    CHECK(app.session.record().pivot < 80);
    // From within the run F8 begins with the worst place, wherever the cursor is.
    app.press("F8");
    CHECK(app["message"].starts_with("Place 1 of 2: "));
    app.press("F8 F8");
    CHECK(app["message"] == "This is the last place.");
    app.press("Esc");
    CHECK(app["alert"].empty());
    const Picture before = app.picture();
    app.press("F8");
    CHECK(app["place"] == "1");
    CHECK(app.session.atEnd());
    CHECK(differing(before, app.picture()) > 500);
    // The worst place is a hole, which is no point, edge or triangle.
    CHECK(app.session.selection().kind == SelectionKind::None);
    app.press("Esc");
    CHECK(app["alert"].empty());
    CHECK(app["place"] != "1");
}

TEST_CASE("Alerts: the rule that prevents one is tried beside the run, then in it, at the camera") {
    DrivenApp app({"scene:four-edge-hole"}, {1600, 980});
    if (!app) return;
    app.press("F8");
    const int alerts = std::stoi(app["alerts"]);
    app.reach("region column", "alert why");
    const std::string at = app.address();
    app.reach("region column", "change beside");
    CHECK(app["compare_with"] == "run");
    CHECK(app["compare_done"] == "true");
    CHECK(app.address() == at);
    app.press("Ctrl+D");
    const CameraPose pose = app.pose();
    app.reach("region column", "change on");
    CHECK(std::stoi(app["alerts"]) < alerts);
    CHECK(app.session.atEnd());
    CHECK(app.pose() == pose);
}

TEST_CASE("The verdict leads to the worst place, its reason, the fix and the file") {
    const test::OwnFolder folder;
    DrivenApp app({test::writePoints(folder / "failing.xyz", test::holedSheet(14, 2))},
                  {1600, 980});
    if (!app) return;
    const std::string before = app["verdict"];
    CHECK(before.starts_with("the mesh has faults at "));
    CHECK(app["place"] == "0");
    CHECK(app["trials_ended"] == "true");
    app.clickOn("verdict worst");
    CHECK(app["place"] == "1");
    CHECK_FALSE(app["alert"].empty());
    CHECK(app["part"] == "Alerts");
    app.clickOn("verdict why");
    CHECK(app["part"] == "Why");
    CHECK_FALSE(app["trial_best"].empty());
    app.clickOn("rail Faults");
    // The pointer on Fix, or on its numbers, shows on the mesh what changes.
    for (const char* name : {"verdict fix", "verdict numbers"}) {
        CHECK(app["tinted"] == "0");
        app.moveTo(app.in(name));
        app.settle();
        CHECK(std::stoi(app["tinted"]) > 0);
        app.moveTo(app.in("region view", 0.7F, 0.8F));
        app.settle();
    }
    CHECK(app["tinted"] == "0");
    app.clickOn("verdict fix");
    CHECK(app["verdict"] != before);
    CHECK(app.session.atEnd());
    CHECK(app["message"].find("; before, it had faults at ") != std::string::npos);
    app.clickOn("verdict save");
    CHECK(app.ui.fileBrowser);
    app.press("Esc");
}

TEST_CASE("From afar a pin stands for a place, and a click on it goes there") {
    DrivenApp app({"scene:noise"});
    if (!app) return;
    app.press("End 1 Shift+F");
    CHECK_FALSE(app.shows("pin 1"));
    for (int i = 0; i < 8; ++i) app.wheel(app.in("region view", 0.7F, 0.8F), -1.0F);
    const CameraPose far = app.pose();
    app.clickOn("pin 1");
    CHECK(app["place"] == "1");
    CHECK(app["message"].starts_with("Place 1 of "));
    CHECK_FALSE(app.pose() == far);
    CHECK_FALSE(app.shows("pin 1"));
}

TEST_CASE("Breakpoints: a line is edited in place, its menu removes one, a lasso makes one") {
    DrivenApp app({"scene:figure-12", "--goto", "0"});
    if (!app) return;
    app.goTo("35.split.1");
    app.press("F9 Esc");
    app.command("breakpoints");
    CHECK(app["part"] == "Breakpoints");
    app.retype("breakpoint 1", "stage=join");
    app.press("Enter");
    CHECK(app["breakpoints"] == R"(["stage=join"])");
    CHECK(app["breakpoint_hits"] != "[null]");
    CHECK(app["breakpoint_hits"] != "[0]");
    app.press("Esc Home F5");
    CHECK(app.address().find(".join.1") != std::string::npos);
    app.goTo("p40");
    app.press("F9");
    CHECK(app["breakpoints"] == R"(["stage=join","point=40"])");
    app.clickOn("breakpoint 2 options");
    app.clickOn("breakpoint 2 away");
    CHECK(app["breakpoints"] == R"(["stage=join"])");
    app.press("Esc Esc");
    // Ctrl and a left drag around points.
    app.holdCtrl(true);
    glm::vec2 at = app.in("region view", 0.35F, 0.35F);
    app.moveTo(at);
    app.hold(0, true);
    for (const glm::vec2 by :
         {glm::vec2(160, 0), glm::vec2(0, 160), glm::vec2(-160, 0), glm::vec2(0, -120)}) {
        app.moveTo(at + 0.5F * by);
        app.moveTo(at += by);
    }
    app.hold(0, false);
    app.holdCtrl(false);
    app.settle();
    CHECK(app["breakpoints"].starts_with(R"(["stage=join","among=)"));
    CHECK_FALSE(app.session.highlights().marked().empty());
}

TEST_CASE("Watch: a number is added by clicks, and a click in its plot goes there") {
    DrivenApp app({"scene:figure-12", "--goto", "100%"});
    if (!app) return;
    const int end = static_cast<int>(app.session.record().pivot);
    app.command("watch");
    CHECK(app["part"] == "Watch");
    app.clickOn("add watch");
    app.clickOn("watch term ring");
    CHECK(app["watches"] == R"(["ring"])");
    CHECK(app["watch_values"] != "[null]");
    app.clickOn("watch plot 1");
    CHECK(std::abs(static_cast<int>(app.session.record().pivot) - end / 2) <= 2);
}

TEST_CASE("Ledger: the box takes a query, clicks copy it, go to its cause and to a line") {
    DrivenApp app({"scene:stranded-point"});
    if (!app) return;
    app.press("W");
    app.type("point 32");
    app.press("Enter");
    CHECK(app.session.selected() == 32);
    app.press("Esc Esc");
    app.goTo("p32");
    app.press("W");
    app.clickOn("ledger copy");
    CHECK(app["notice"].starts_with("Copied the answer"));
    app.session.waitUntilDone();
    app.clickOn("ledger cause");
    const std::string cause = "71.limits.4";
    CHECK(app.address() == cause);
    app.press("[");
    const std::string here = app.address();
    CHECK(here != cause);
    app.press("]");
    app.clickOn("line " + here);
    CHECK(app.address() == here);
    // An edge of no points leaves the answer of the one before.
    for (const char* typed : {"12,40", "12,4000"}) {
        app.retype("ledger box", typed);
        app.press("Enter");
        CHECK(app.session.selection() == Selection::ofEdge(12, 40));
    }
}

TEST_CASE("Ledger: a new answer shows its cause, below a sentence and buttons that stay") {
    DrivenApp app({"scene:noise"}, {1024, 640});
    if (!app) return;
    app.press("F8 W");
    const Ledger* answer = app.session.questions().why();
    REQUIRE(answer != nullptr);
    REQUIRE(answer->cause > 10);
    const std::string cause = "line " + toString(answer->lines[answer->cause].event.address);
    const Rect column = app.ui.where.at("region column");
    CHECK(app.shows(cause));
    for (const char* button : {"ledger cause", "ledger copy", "change on", "change beside"}) {
        CAPTURE(button);
        REQUIRE(app.shows(button));
        CHECK(app.ui.where.at(button).max().x <= column.max().x);
    }
    const glm::vec2 list = app.in(cause);
    for (int i = 0; i < 40; ++i) app.wheel(list, 1.0F);
    CHECK_FALSE(app.shows(cause));
    CHECK(app.shows("ledger copy"));
}

TEST_CASE("Ledger: repeats are one row, until it is clicked or the cursor comes there") {
    DrivenApp app({"scene:stranded-point"}, {1280, 1600});
    if (!app) return;
    app.press("W");
    app.retype("ledger box", "20");
    app.press("Enter");
    REQUIRE(app.shows("line 13.sort.5"));
    CHECK_FALSE(app.shows("line 24.sort.6"));
    app.goTo("24.sort.6");
    CHECK(app.shows("line 24.sort.6"));
    app.goTo("0");
    CHECK_FALSE(app.shows("line 24.sort.6"));
    app.clickOn("fold 23.sort.9");
    CHECK(app.shows("line 24.sort.6"));
    app.clickOn("line 24.sort.6");
    CHECK(app.address() == "24.sort.6");
}

TEST_CASE("Ledger: the decision that it was asked at comes first") {
    DrivenApp app({"scene:torus", "--goto", "137.sphere.3"});
    if (!app) return;
    const std::string here = describe(*app.session.event()) + " (137.sphere.3)\n";
    app.press("W");
    app.type("242");
    app.press("Enter");
    app.clickOn("ledger copy");
    const auto copied = [] { return std::string(ImGui::GetClipboardText()); };
    CHECK(copied().starts_with(here + "Point 242 is in the mesh"));
    // Elsewhere in the run the answer is that to the question, as long as it is not asked again.
    app.clickOn("ledger cause");
    app.clickOn("ledger copy");
    CHECK(copied().starts_with(here));
    app.press("W");
    app.clickOn("ledger copy");
    CHECK(copied().starts_with("Point 242 is in the mesh"));
}

TEST_CASE("A right click in the view queries what is there") {
    DrivenApp app({"scene:stranded-point", "--goto", "60", "--focus"});
    if (!app) return;
    app.press("Esc");
    app.press("F");
    const Rect view = app.ui.where.at("region view");
    const glm::vec3& pivot = app.session.model().place[app.session.picture().pivot];
    const glm::vec2 at = view.min + glm::vec2(project(app.app.camera().matrices(app.ui.viewAspect),
                                                      pivot, view.size));
    app.click(at);
    REQUIRE(app.session.selection().kind == SelectionKind::Point);
    const Selection there = app.session.selection();
    app.press("Esc");
    app.click(at, 1);
    app.clickOn("menu why");
    CHECK(app.session.selection() == there);
    CHECK(app["ledger"].find(selectionText(there)) != std::string::npos);
}

TEST_CASE("Query: a click on a line goes there, bars of the charts lead to lists") {
    DrivenApp app({"scene:stranded-point"});
    if (!app) return;
    app.press("Ctrl+F");
    app.type("stage=sphere refused");
    app.press("Enter Home F3 F3");
    const std::string second = app.address();
    app.press("Shift+F3");
    app.reach("region column", "line " + second);
    CHECK(app.address() == second);
    app.command("charts");
    app.reach("region column", "bar refusals sort");
    CHECK(app["part"] == "Query");
    CHECK(app["query"].find(R"("line":"stage=sort refused")") != std::string::npos);
    app.command("closest decisions");
    app.press("Home");
    const Picture plain = app.picture();
    app.clickOn("tint margin");
    CHECK(differing(plain, app.picture()) > 500);
}
