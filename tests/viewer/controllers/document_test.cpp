#include "headless_app.h"

#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>

using namespace se;
using namespace se::view;
namespace fs = std::filesystem;

namespace {

struct FilingDesk : test::Desk {
    FilingDesk() : test::Desk("filing-test") {}
    void open(const std::string& path) {
        filing.open(path);
        settle();
    }
    void save(const fs::path& path) {
        ui.requests.saveSessionAs = path;
        filing.carryOut(ui.requests);
    }
    std::string place() { return toString(session.address()); }
};

}  // namespace

TEST_CASE("A saved session is restored: position, camera, layers, layout, selection, notes") {
    FilingDesk desk;
    desk.open("scene:sphere");
    REQUIRE(desk.session.goToText("12.sort.2").ok());
    desk.settle();
    desk.session.select(33);
    desk.camera.set(ViewPreset::Top);
    const CameraPose camera = desk.camera.pose();
    modeOf(desk.ui.settings.layers, LayerId::Normals) = LayerMode::PinnedOn;
    const LayerModes layers = desk.ui.settings.layers;
    desk.ui.arrangement = Arrangement::Learn;
    desk.ui.notes = "odd";
    toggleBookmark(desk.ui.bookmarks, desk.session.address());
    const fs::path path = desk.folder / "a.sesession";
    desk.save(path);
    CHECK(desk.ui.sessionPath == path);

    FilingDesk other;
    desk.save(path);  // the second desk has emptied the folder
    other.open(path.string());
    CHECK(other.place() == "12.sort.2");
    CHECK(other.session.selected() == 33);
    const auto pose = other.filing.takeCamera();
    REQUIRE(pose.has_value());
    CHECK(pose->pitchDegrees == doctest::Approx(camera.pitchDegrees));
    CHECK_FALSE(other.filing.takeCamera().has_value());
    CHECK(other.ui.settings.layers == layers);
    CHECK(other.ui.arrangement == Arrangement::Learn);
    CHECK(other.ui.notes == "odd");
    CHECK(other.ui.bookmarks == desk.ui.bookmarks);
    CHECK(other.ui.sessionPath == path);
}

TEST_CASE("An input that has changed since is a warning, not an error") {
    FilingDesk desk;
    desk.open("scene:sphere");
    const fs::path path = desk.folder / "a.sesession";
    SessionFile file = captureSession(desk.context);
    file.inputHash = "fnv1a64:0000000000000000";
    REQUIRE(writeSessionFile(path, file).ok());
    desk.open(path.string());
    desk.filing.poll();
    CHECK(desk.session.phase() == SessionPhase::Ready);
    CHECK(desk.session.message().find("has changed") != std::string::npos);
}

TEST_CASE("A bad session leaves the open input unchanged and gives the reason") {
    FilingDesk desk;
    desk.open("scene:sphere");
    std::ofstream(desk.folder / "bad.sesession") << "{";
    desk.open((desk.folder / "bad.sesession").string());
    CHECK(desk.session.ready());
    CHECK(desk.session.spec().source == "scene:sphere");
    CHECK(desk.session.message().find("bad.sesession") != std::string::npos);
}

TEST_CASE("Notes belong to their input, and wait until it is opened again") {
    FilingDesk desk;
    desk.open("scene:sphere");
    desk.ui.notes = "about the sphere";
    toggleBookmark(desk.ui.bookmarks, {3, Stage::Sort, 1});
    desk.open("scene:grid");
    CHECK(desk.ui.notes.empty());
    CHECK(desk.ui.bookmarks.empty());
    desk.open("scene:sphere");
    CHECK(desk.ui.notes == "about the sphere");
    CHECK(desk.ui.bookmarks.size() == 1);
}

TEST_CASE("The first save asks for a name, later ones do not") {
    FilingDesk desk;
    desk.open("scene:sphere");
    desk.ui.requests.saveSession = true;
    desk.filing.carryOut(desk.ui.requests);
    CHECK(desk.ui.fileBrowser);
    CHECK(desk.ui.browser == BrowserTask::SaveSession);
    desk.ui.fileBrowser = false;
    const fs::path path = desk.folder / "a.sesession";
    desk.save(path);
    desk.ui.notes = "later";
    desk.ui.requests.saveSession = true;
    desk.filing.carryOut(desk.ui.requests);
    CHECK_FALSE(desk.ui.fileBrowser);
    CHECK(readSessionFile(path).value().notes == "later");
}

TEST_CASE("Recent files and layout are kept in the state file, and only if there is one") {
    FilingDesk desk;
    const fs::path state = desk.folder / "state" / "state.json";
    desk.open("scene:sphere");
    desk.save(desk.folder / "before.sesession");
    CHECK(desk.ui.recent.empty());
    desk.filing.keepIn(state, false);
    const fs::path path = desk.folder / "a.sesession";
    desk.save(path);
    desk.ui.arrangement = Arrangement::Present;
    desk.filing.poll();
    CHECK(desk.ui.recent == std::vector<std::string>{path.string()});
    CHECK(readKeptState(state) == KeptState{Arrangement::Present, {path.string()}});
}

TEST_CASE("Edits are captured and restored unchanged") {
    FilingDesk desk;
    desk.open("scene:sphere");
    const Edits before = captureEdits(desk.context);
    desk.session.select(5);
    desk.camera.set(ViewPreset::Front);
    desk.ui.settings.theme = Theme::Light;
    desk.ui.notes = "x";
    Edits after = captureEdits(desk.context);
    CHECK(after != before);
    applyEdits(before, desk.context);
    CHECK(captureEdits(desk.context) == before);
}

TEST_CASE("An edge or a triangle that is selected is kept, and comes back by undo") {
    FilingDesk desk;
    desk.open("scene:sphere");
    const std::vector<Selection> picked = {Selection::ofEdge(9, 4),
                                           Selection::ofTriangle({7, 5, 6})};
    for (const Selection& each : picked) {
        desk.session.select(each);
        const fs::path path = desk.folder / "picked.sesession";
        FilingDesk other;  // empties the folder
        desk.save(path);
        other.open(path.string());
        CHECK(other.session.selection() == each);
        const Edits edits = captureEdits(desk.context);
        desk.session.select(Selection{});
        applyEdits(edits, desk.context);
        CHECK(desk.session.selection() == each);
    }
}

TEST_CASE("Bookmarks and notes are unsaved until a session file holds them") {
    FilingDesk desk;
    desk.open("scene:sphere");
    CHECK(desk.filing.unsaved().empty());
    desk.ui.notes = "odd";
    CHECK_FALSE(desk.filing.unsaved().empty());
    desk.save(desk.folder / "noted.sesession");
    CHECK(desk.filing.unsaved().empty());
    toggleBookmark(desk.ui.bookmarks, desk.session.address());
    CHECK_FALSE(desk.filing.unsaved().empty());
    desk.open("scene:torus");
    CHECK(desk.filing.unsaved().empty());
    desk.open("scene:sphere");
    CHECK_FALSE(desk.filing.unsaved().empty());
    desk.open((desk.folder / "noted.sesession").string());
    CHECK(desk.filing.unsaved().empty());
}

TEST_CASE("A session older than the up axis opens with z up; a new one keeps its own") {
    FilingDesk desk;
    const auto openWith = [&](const std::string& camera) {
        const fs::path path = desk.folder / "up.sesession";
        std::ofstream(path) << R"({"format": "spiraling-edge session", "version": 1,)"
                            << R"( "input": {"source": "scene:grid"})" << camera << "}";
        desk.open(path.string());
        return desk.filing.takeCamera();
    };
    const auto old =
        openWith(R"(, "camera": {"target": [0, 0, 0], "distance": 3, "yaw": 10, "pitch": 20})");
    REQUIRE(old.has_value());
    CHECK(old->up == UpAxis::Z);
    CHECK_FALSE(openWith("").has_value());
    // A session without a camera has z up.
    CHECK(desk.filing.openedSession());
    desk.camera.setUp(UpAxis::X);
    const fs::path path = desk.folder / "new.sesession";
    desk.save(path);
    desk.open("scene:sphere");
    CHECK_FALSE(desk.filing.openedSession());
    desk.open(path.string());
    const auto kept = desk.filing.takeCamera();
    REQUIRE(kept.has_value());
    CHECK(kept->up == UpAxis::X);
}
