#include "headless_app.h"

#include <doctest/doctest.h>

#include <filesystem>

using namespace se;
using namespace se::view;
namespace fs = std::filesystem;

namespace {

/// A program with an open scene.
struct LeavingDesk : test::Desk {
    LeavingDesk() : test::Desk("leaving-test") {
        filing.open("scene:sphere");
        frame();
    }
    void frame() {
        filing.carryOut(ui.requests);
        settle();
    }
    void quit() {
        ui.requests.quit = true;
        frame();
    }
    void open(const std::string& source) {
        ui.requests.open = source;
        frame();
    }
    void answer(LeaveAnswer answer) {
        ui.leaving.answer = answer;
        frame();
    }
};

}  // namespace

TEST_CASE("There is no question without annotations, or after they were undone") {
    LeavingDesk desk;
    desk.open("scene:grid");
    CHECK(desk.session.spec().source == "scene:grid");
    const Address here{3, Stage::Sort, 1};
    toggleBookmark(desk.ui.bookmarks, here);
    toggleBookmark(desk.ui.bookmarks, here);
    desk.ui.requests.reload = true;
    desk.frame();
    CHECK_FALSE(desk.ui.leaving.asked);
    desk.quit();
    CHECK_FALSE(desk.ui.leaving.asked);
    CHECK(desk.ui.quitting);
}

TEST_CASE("Quitting with notes asks; cancelling stays, discarding quits") {
    LeavingDesk desk;
    desk.ui.notes = "odd";
    desk.quit();
    CHECK(desk.ui.leaving.asked);
    CHECK_FALSE(desk.ui.quitting);
    desk.answer(LeaveAnswer::Cancel);
    CHECK_FALSE(desk.ui.leaving.asked);
    CHECK_FALSE(desk.ui.quitting);
    CHECK(desk.ui.notes == "odd");
    desk.quit();
    desk.answer(LeaveAnswer::Discard);
    CHECK(desk.ui.quitting);
}

TEST_CASE("Unsaved breakpoints and watches raise the question like notes, by name") {
    LeavingDesk desk;
    desk.ui.breakpoints.push_back({"", "stage=split"});
    desk.ui.watches = {"ring"};
    desk.quit();
    REQUIRE(desk.ui.leaving.asked);
    CHECK(desk.ui.leaving.atStake == "breakpoints and watches");
    desk.answer(LeaveAnswer::Cancel);
    CHECK(desk.ui.breakpoints.size() == 1);
    desk.ui.requests.saveSessionAs = (desk.folder / "a.sesession").string();
    desk.frame();
    CHECK(desk.filing.unsaved().empty());

    // Discarding returns to the content of the file.
    desk.ui.breakpoints.front().logOnly = true;
    desk.ui.watches.clear();
    desk.ui.notes = "odd";
    desk.ui.requests.reload = true;
    desk.frame();
    REQUIRE(desk.ui.leaving.asked);
    CHECK(desk.ui.leaving.atStake == "notes, breakpoints and watches");
    desk.answer(LeaveAnswer::Discard);
    REQUIRE(desk.ui.breakpoints.size() == 1);
    CHECK_FALSE(desk.ui.breakpoints.front().logOnly);
    CHECK(desk.ui.watches == std::vector<std::string>{"ring"});
    CHECK(desk.ui.notes.empty());
}

TEST_CASE("Opening and reloading ask as well; discarding restores the content of the file") {
    LeavingDesk desk;
    desk.ui.notes = "saved";
    desk.ui.requests.saveSessionAs = (desk.folder / "a.sesession").string();
    desk.frame();
    desk.ui.notes = "changed";
    desk.open("scene:grid");
    CHECK(desk.session.spec().source == "scene:sphere");
    REQUIRE(desk.ui.leaving.asked);
    desk.answer(LeaveAnswer::Discard);
    CHECK(desk.session.spec().source == "scene:grid");
    CHECK(desk.ui.notes.empty());
    desk.open("scene:sphere");
    CHECK_FALSE(desk.ui.leaving.asked);
    CHECK(desk.ui.notes == "saved");
    desk.ui.notes = "changed again";
    const std::uint32_t before = desk.session.generation();
    desk.ui.requests.reload = true;
    desk.frame();
    REQUIRE(desk.ui.leaving.asked);
    CHECK(desk.session.generation() == before);
    desk.answer(LeaveAnswer::Discard);
    CHECK(desk.session.generation() > before);
    CHECK(desk.ui.notes == "saved");
}

TEST_CASE("Saving first continues when the file is written, and stays if no name is given") {
    LeavingDesk desk;
    desk.ui.notes = "odd";
    desk.open("scene:grid");
    desk.answer(LeaveAnswer::Save);
    REQUIRE(desk.ui.fileBrowser);
    CHECK(desk.session.spec().source == "scene:sphere");
    desk.ui.fileBrowser = false;  // no file is named
    desk.frame();
    desk.frame();
    CHECK(desk.session.spec().source == "scene:sphere");

    desk.open("scene:grid");
    desk.answer(LeaveAnswer::Save);
    const fs::path path = desk.folder / "a.sesession";
    desk.ui.requests.saveSessionAs = path.string();
    desk.ui.fileBrowser = false;
    desk.frame();
    CHECK(desk.session.spec().source == "scene:grid");
    CHECK(readSessionFile(path).value().notes == "odd");

    // The file has a name now.
    desk.open("scene:sphere");
    desk.ui.notes = "odder";
    desk.quit();
    desk.answer(LeaveAnswer::Save);
    CHECK_FALSE(desk.ui.fileBrowser);
    CHECK(desk.ui.quitting);
    CHECK(readSessionFile(path).value().notes == "odder");
}

TEST_CASE("A session that cannot be saved is not left") {
    LeavingDesk desk;
    desk.ui.notes = "odd";
    desk.quit();
    desk.answer(LeaveAnswer::Save);
    desk.ui.requests.saveSessionAs = (desk.folder / "no" / "a.sesession").string();
    desk.ui.fileBrowser = false;
    desk.frame();
    CHECK_FALSE(desk.ui.quitting);
    CHECK(desk.ui.notes == "odd");
}

TEST_CASE("A file that cannot be opened leaves notes and input unchanged") {
    LeavingDesk desk;
    desk.ui.notes = "odd";
    desk.filing.open("missing.ply");
    desk.frame();
    CHECK(desk.session.phase() == SessionPhase::Failed);
    desk.session.dismissError();
    CHECK(desk.session.spec().source == "scene:sphere");
    CHECK(desk.ui.notes == "odd");
}

TEST_CASE("Of several files that are dropped the first is opened, and a sentence reports it") {
    LeavingDesk desk;
    desk.filing.drop({"scene:grid", "scene:torus"});
    desk.frame();
    desk.filing.poll();
    CHECK(desk.session.spec().source == "scene:grid");
    CHECK(desk.session.message().find("2 files") != std::string::npos);
    CHECK(desk.session.message().find("scene:grid") != std::string::npos);
    desk.ui.notes = "odd";
    desk.filing.drop({"scene:torus"});
    CHECK(desk.ui.leaving.asked);
}
