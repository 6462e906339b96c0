/// The layout Compare as the mouse reaches it: the other run by its form, by a mesh and by a trace.
#include <doctest/doctest.h>

#include <fstream>

#include "../../teach/trace/traced_scenes.h"
#include "driven_app.h"
#include "open_session.h"

using namespace se;
using namespace se::view;
using test::differing;
using test::DrivenApp;
using test::OwnFolder;

TEST_CASE("Compare: a lasso follows the pointer in the view where it began") {
    for (const char* view : {"region view", "region other view"}) {
        CAPTURE(view);
        DrivenApp app({"scene:torus"});
        if (!app) return;
        app.press("Ctrl+D");
        app.clickOn("compare usual");
        const auto corners = [&] { return app.ui.states.of<BreakLasso>().line.path.size(); };
        app.holdCtrl(true);
        app.moveTo(app.in(view, 0.2F, 0.2F));
        app.hold(0, true);
        for (const glm::vec2 at : {glm::vec2(0.8F, 0.2F), glm::vec2(0.8F), glm::vec2(0.2F, 0.8F)})
            app.moveTo(app.in(view, at.x, at.y));
        const std::size_t drawn = corners();
        CHECK(drawn == 4);
        app.frames(3);
        CHECK(corners() == drawn);
        app.hold(0, false);
        app.holdCtrl(false);
        app.settle();
        CHECK(app["breakpoints"].find("among=") != std::string::npos);
    }
}

TEST_CASE("Compare: a click chooses the other run, keys lead through differences and regions") {
    DrivenApp app({"scene:torus"});
    if (!app) return;
    app.press("D");
    CHECK(app["notice"].starts_with("No comparison"));
    app.press("Ctrl+D");
    CHECK(app["layout"] == "compare");
    app.clickOn("compare usual");
    CHECK(app["difference_a"] == "7.sphere.1");
    CHECK(app["difference_b"] == "7.sphere.3");
    const auto areAt = [&](const char* a, const char* b) {
        return app.address() == a && app["other_address"] == b;
    };
    app.goTo("5.sort.3");
    app.press("Right");
    CHECK(areAt("5.sort.4", "5.sort.4"));
    app.press("End");
    const std::string end = app["other_address"];
    CameraPose pose = app.pose();
    app.press("D");
    CHECK(areAt("7.sphere.1", "7.sphere.3"));
    CHECK_FALSE(app.pose() == pose);  // the pivot is framed
    // The first difference has a mark on the strip; a click there has the effect of its key.
    app.press("End");
    app.clickOn("strip difference");
    CHECK(areAt("7.sphere.1", "7.sphere.3"));
    app.press("Shift+D");
    CHECK(app["region"] == "1");
    CHECK(app["other_address"] == end);
    app.press("Shift+D");
    CHECK(app["region"] == "2");
    app.press("Ctrl+Shift+D");
    CHECK(app["region"] == "1");
    app.clickOn("compare region 2");
    CHECK(app["region"] == "2");
    // A drag in the other view turns both.
    app.press("Enter");
    pose = app.pose();
    app.drag(app.in("region other view"), {80, 20});
    CHECK_FALSE(app.pose() == pose);
    app.clickOn("compare swap");
    CHECK(app["other_rules"] == "paper");
    CHECK(app["difference_a"] == "7.sphere.3");
    CHECK(app["difference_b"] == "7.sphere.1");
    app.clickOn("compare stop");
    CHECK(app["compare_with"] == "null");
    app.press("Ctrl+D");
    CHECK(app["layout"] == "debug");
}

TEST_CASE("Compare: the command line leads to the first difference of a scene that fails") {
    DrivenApp app({"scene:four-edge-hole", "--layout", "compare", "--with", "--rules robust",
                   "--goto", "difference"});
    if (!app) return;
    CHECK(app.address() == app["difference_a"]);
    CHECK(app["other_address"] == app["difference_b"]);
}

TEST_CASE("Compare: the form takes rules, lists and a what-if, a right click asks both runs") {
    DrivenApp app({"scene:torus", "--layout", "compare"});
    if (!app) return;
    app.clickOn("compare part Rules");
    app.clickOn("compare rules filter");
    app.type("maxgap");
    app.retype("compare rule maxgap", "100");
    app.press("Enter");
    app.clickOn("compare part Rules");
    app.clickOn("compare part Input");
    app.retype("compare prepare count", "16");
    app.clickOn("compare prepare Symmetric");
    app.clickOn("compare part Input");
    app.clickOn("compare part What if");
    app.clickOn("compare what if line");
    app.type("60.advance pivot 9999");
    app.press("Enter");
    app.clickOn("compare what if 1");
    app.clickOn("compare begin");
    CHECK(app["compare_done"] == "true");
    CHECK(app["compare_other"] == "robust rules, maxgap 100, 16 neighbors, symmetric lists");
    app.goTo("300.sphere.1");
    app.press("F");
    app.click(app.in("region other view"), 1);
    app.clickOn("menu why");
    CHECK_FALSE(app["compare_why"].empty());
    CHECK_FALSE(app["compare_why_other"].empty());
    const std::string at = app.address();
    app.clickOn("compare cause");
    CHECK(app.address() != at);
    app.clickOn("compare why close");
    app.clickOn("compare other");
    app.clickOn("compare back");
    CHECK(app["compare_done"] == "true");
    // Other panels are beside both views as well.
    app.command("rules");
    CHECK(app["layout"] == "compare");
    CHECK(app["part"] == "Rules");
    CHECK(app["choices"] == "[]");
}

TEST_CASE("Compare: a mesh of a file is beside the run in a small window, and has no decisions") {
    const OwnFolder folder;
    const std::string mesh = (folder / "other.off").string();
    std::ofstream(mesh) << "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
    DrivenApp app({"scene:torus", "--layout", "compare", "--ui-scale", "2", "--with", mesh},
                  {1024, 640});
    if (!app) return;
    CHECK(app["compare_with"] == "mesh");
    CHECK(app["only_b"] == "1");
    app.press("D");
    CHECK(app.address() == "1.emit.1");
    app.click(app.in("region other view"), 1);
    CHECK(app.shows("menu beside"));
}

TEST_CASE("Compare: a trace opened as a file is beside the run, its sentences lead to decisions") {
    const OwnFolder folder;
    const std::string path = (folder / "mine.setrace").string();
    const std::string kept = (folder / "kept.sesession").string();
    const auto openTrace = [&](DrivenApp& each) {
        each.press("Ctrl+O");
        each.type(path);
        each.press("Enter");
    };
    {
        DrivenApp app({"scene:figure-8"});
        if (!app) return;
        {
            const SharedPoints points(app.session.model().points);
            std::ofstream(path) << teach::traceText(
                points, teach::withRule(app.session.model().params, "limits=off"));
        }
        openTrace(app);
        CHECK(app["layout"] == "compare");
        CHECK(app["compare_with"] == "trace");
        CHECK(app["trace_difference"].starts_with("after 7 pivots alike, pivot 8 (point 11 "));
        CHECK(app["trace_guess"] == "your whole trace, 83 pivots, behaves like --rule limits=off");
        app.press("D");
        CHECK(app.address() == "8.limits.1");
        CHECK(app["trace_sentence"].starts_with(
            "Pivot 8 of the trace: point 11 between 1 and 3, fan "));
        app.clickOn("trace reason 2");
        CHECK(app.address() == "8.sphere.1");
        // In step before the difference: the fan is laid as ours is.
        app.goTo("7.emit.1");
        const Picture one = app.picture();
        app.goTo("7");
        CHECK(differing(one, app.picture()) > 200);
        app.save(kept);
        app.clickOn("compare stop");
        CHECK(app["compare_with"] == "null");
    }
    {
        DrivenApp again({kept});
        CHECK(again["layout"] == "compare");
        CHECK(again["compare_with"] == "trace");
        CHECK(again["compare_done"] == "true");
    }
    // Without an open run it asks for its points, and is beside their run once they are there.
    const auto offersPoints = [](DrivenApp& each) {
        CHECK(each.session.messages().last() ==
              "mine.setrace is a trace: open the points that it is of.");
        each.type("scene:figure-8");
        each.press("Enter");
        CHECK(each["layout"] == "compare");
        CHECK(each["compare_with"] == "trace");
        CHECK(each["compare_done"] == "true");
    };
    {
        DrivenApp none({});
        openTrace(none);
        offersPoints(none);
    }
    DrivenApp alone({path});
    offersPoints(alone);
}
