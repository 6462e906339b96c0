#include "headless_app.h"

#include <doctest/doctest.h>

#include <filesystem>

#include "document/actions.h"
#include "spiraling_edge/spec/run_spec.h"

using namespace se;
using namespace se::view;
namespace fs = std::filesystem;

namespace {

/// A program with an open scene.
struct LeavingApp : test::HeadlessApp {
    LeavingApp() : test::HeadlessApp("leaving-test") {
        document.open("scene:sphere");
        frame();
    }
    void frame() { waitUntilDone(); }
    void quit() {
        document.quit();
        frame();
    }
    void open(const std::string& source) {
        document.open(source);
        frame();
    }
    void answer(LeaveAnswer answer) {
        document.answer(answer);
        frame();
    }
};

}  // namespace

TEST_CASE("There is no question without annotations, or after they were undone") {
    LeavingApp app;
    app.open("scene:grid");
    CHECK(app.session.input().spec().source == "scene:grid");
    const Address here{3, Stage::Sort, 1};
    toggleBookmark(app.ui.bookmarks, here);
    toggleBookmark(app.ui.bookmarks, here);
    app.document.reload();
    app.frame();
    CHECK_FALSE(app.ui.leaving.asked);
    app.quit();
    CHECK_FALSE(app.ui.leaving.asked);
    CHECK(app.ui.quitting);
}

TEST_CASE("Quitting with notes asks, cancelling stays, discarding quits") {
    LeavingApp app;
    app.ui.notes = "odd";
    app.quit();
    CHECK(app.ui.leaving.asked);
    CHECK_FALSE(app.ui.quitting);
    app.answer(LeaveAnswer::Cancel);
    CHECK_FALSE(app.ui.leaving.asked);
    CHECK_FALSE(app.ui.quitting);
    CHECK(app.ui.notes == "odd");
    app.quit();
    app.answer(LeaveAnswer::Discard);
    CHECK(app.ui.quitting);
}

TEST_CASE("Unsaved breakpoints and watches raise the question like notes, by name") {
    LeavingApp app;
    app.ui.breakpoints.push_back({"", "stage=split"});
    app.ui.watch.expressions = {"ring"};
    app.quit();
    REQUIRE(app.ui.leaving.asked);
    CHECK(app.ui.leaving.atStake == "breakpoints and watches");
    app.answer(LeaveAnswer::Cancel);
    CHECK(app.ui.breakpoints.size() == 1);
    app.document.saveAs((app.folder / "a.sesession").string());
    app.frame();
    CHECK(app.document.unsaved().empty());

    // Discarding returns to the content of the file.
    app.ui.breakpoints.front().logOnly = true;
    app.ui.watch.expressions.clear();
    app.ui.notes = "odd";
    app.document.reload();
    app.frame();
    REQUIRE(app.ui.leaving.asked);
    CHECK(app.ui.leaving.atStake == "notes, breakpoints and watches");
    app.answer(LeaveAnswer::Discard);
    REQUIRE(app.ui.breakpoints.size() == 1);
    CHECK_FALSE(app.ui.breakpoints.front().logOnly);
    CHECK(app.ui.watch.expressions == std::vector<std::string>{"ring"});
    CHECK(app.ui.notes.empty());
}

TEST_CASE("Other settings than those of the opening are asked about, until they are saved") {
    LeavingApp app;
    const auto runByRobust = [&] {
        app.document.rerun(withRule(app.session.input().spec(), "fill", 1.0));
        app.frame();
    };
    runByRobust();
    app.quit();
    REQUIRE(app.ui.leaving.asked);
    CHECK(app.ui.leaving.atStake == "settings of the run");
    app.answer(LeaveAnswer::Cancel);
    // Running again asks nothing: the settings stay.
    app.document.reload();
    app.frame();
    CHECK_FALSE(app.ui.leaving.asked);
    // With the mesh they are saved.
    actions::saveMesh(app.context);
    app.mesh.save(app.folder / "a.ply");
    app.mesh.waitUntilDone();
    app.quit();
    CHECK_FALSE(app.ui.leaving.asked);
    CHECK(app.ui.quitting);
}

TEST_CASE("Opening and reloading ask as well, discarding restores the content of the file") {
    LeavingApp app;
    app.ui.notes = "saved";
    app.document.saveAs((app.folder / "a.sesession").string());
    app.frame();
    app.ui.notes = "changed";
    app.open("scene:grid");
    CHECK(app.session.input().spec().source == "scene:sphere");
    REQUIRE(app.ui.leaving.asked);
    app.answer(LeaveAnswer::Discard);
    CHECK(app.session.input().spec().source == "scene:grid");
    CHECK(app.ui.notes.empty());
    app.open("scene:sphere");
    CHECK_FALSE(app.ui.leaving.asked);
    CHECK(app.ui.notes == "saved");
    app.ui.notes = "changed again";
    const std::uint32_t before = app.session.generation();
    app.document.reload();
    app.frame();
    REQUIRE(app.ui.leaving.asked);
    CHECK(app.session.generation() == before);
    app.answer(LeaveAnswer::Discard);
    CHECK(app.session.generation() > before);
    CHECK(app.ui.notes == "saved");
}

TEST_CASE("Saving first continues when the file is written, and stays if no name is given") {
    LeavingApp app;
    app.ui.notes = "odd";
    app.open("scene:grid");
    app.answer(LeaveAnswer::Save);
    REQUIRE(app.ui.fileBrowser);
    CHECK(app.session.input().spec().source == "scene:sphere");
    app.ui.fileBrowser = false;  // no file is named
    app.frame();
    app.frame();
    CHECK(app.session.input().spec().source == "scene:sphere");

    app.open("scene:grid");
    app.answer(LeaveAnswer::Save);
    const fs::path path = app.folder / "a.sesession";
    app.document.saveAs(path.string());
    app.ui.fileBrowser = false;
    app.frame();
    CHECK(app.session.input().spec().source == "scene:grid");
    CHECK(readSessionFile(path).value().annotations.notes == "odd");

    // The file has a name now.
    app.open("scene:sphere");
    app.ui.notes = "odder";
    app.quit();
    app.answer(LeaveAnswer::Save);
    CHECK_FALSE(app.ui.fileBrowser);
    CHECK(app.ui.quitting);
    CHECK(readSessionFile(path).value().annotations.notes == "odder");
}

TEST_CASE("A session that cannot be saved is not left") {
    LeavingApp app;
    app.ui.notes = "odd";
    app.quit();
    app.answer(LeaveAnswer::Save);
    app.document.saveAs((app.folder / "no" / "a.sesession").string());
    app.ui.fileBrowser = false;
    app.frame();
    CHECK_FALSE(app.ui.quitting);
    CHECK(app.ui.notes == "odd");
}

TEST_CASE("A file that cannot be opened leaves notes and input unchanged") {
    LeavingApp app;
    app.ui.notes = "odd";
    app.document.saveAs((app.folder / "a.sesession").string());
    app.document.open("missing.ply");
    app.frame();
    CHECK(app.session.input().phase() == SessionPhase::Failed);
    app.session.dismissError();
    CHECK(app.session.input().spec().source == "scene:sphere");
    CHECK(app.ui.notes == "odd");
}

TEST_CASE("Of several files that are dropped the first is opened, and a sentence reports it") {
    LeavingApp app;
    app.document.drop({"scene:grid", "scene:torus"});
    app.frame();
    app.document.poll();
    CHECK(app.session.input().spec().source == "scene:grid");
    CHECK(app.session.messages().last().find("2 files") != std::string::npos);
    CHECK(app.session.messages().last().find("scene:grid") != std::string::npos);
    app.ui.notes = "odd";
    app.document.drop({"scene:torus"});
    CHECK(app.ui.leaving.asked);
}
