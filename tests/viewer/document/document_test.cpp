#include "headless_app.h"

#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "spiraling_edge/spec/spec_fields.h"

using namespace se;
using namespace se::view;
namespace fs = std::filesystem;

namespace {

struct DocumentApp : test::HeadlessApp {
    DocumentApp() : test::HeadlessApp("document-test") {}
    void open(const std::string& path) { openInstead(path); }
    /// Opens an input as a lesson does: without asking about unsaved work.
    void openBeside(const std::string& source) {
        document.openStep(RunSpec{source}, "");
        waitUntilDone();
    }
    void save(const fs::path& path) { document.saveAs(path); }
    std::string place() { return toString(session.address()); }
};

}  // namespace

TEST_CASE("A saved session is restored: position, camera, layers, layout, selection, notes") {
    DocumentApp app;
    app.open("scene:sphere");
    REQUIRE(app.session.moves().goToText("12.sort.2").ok());
    app.waitUntilDone();
    app.session.select(33);
    app.camera.set(ViewPreset::Top);
    const CameraPose camera = app.camera.pose();
    modeOf(app.ui.settings.layers, LayerId::Normals) = LayerMode::PinnedOn;
    const LayerModes layers = app.ui.settings.layers;
    app.ui.layoutPreset = LayoutPreset::Present;
    app.ui.notes = "odd";
    toggleBookmark(app.ui.bookmarks, app.session.address());
    const fs::path path = app.folder / "a.sesession";
    app.save(path);
    CHECK(app.ui.sessionPath == path);

    DocumentApp other;
    app.save(path);  // the second app has emptied the folder
    other.open(path.string());
    CHECK(other.place() == "12.sort.2");
    CHECK(other.session.selected() == 33);
    const auto pose = other.document.takeCamera();
    REQUIRE(pose.has_value());
    CHECK(pose->pitchDegrees == doctest::Approx(camera.pitchDegrees));
    CHECK_FALSE(other.document.takeCamera().has_value());
    CHECK(other.ui.settings.layers == layers);
    CHECK(other.ui.layoutPreset == LayoutPreset::Present);
    CHECK(other.ui.notes == "odd");
    CHECK(other.ui.bookmarks == app.ui.bookmarks);
    CHECK(other.ui.sessionPath == path);
}

TEST_CASE("A session that is dropped with its points is opened, and one with others is not") {
    DocumentApp app;
    const std::string points = (app.folder / "plane.xyz").string();
    const std::string others = (app.folder / "others.xyz").string();
    for (const std::string& path : {points, others}) {
        std::ofstream file(path);
        for (int i = 0; i < 9; ++i) file << i % 3 << ' ' << i / 3 << " 0 0 0 1\n";
    }
    app.open(points);
    app.ui.notes = "mine";
    const std::string session = (app.folder / "a.sesession").string();
    app.save(session);
    app.open("scene:sphere");
    app.document.drop({points, session});
    app.waitUntilDone();
    CHECK(app.ui.notes == "mine");
    CHECK(app.session.messages().notice().find("were dropped") == std::string::npos);
    app.open("scene:sphere");
    app.document.drop({others, session});
    app.waitUntilDone();
    CHECK(app.session.input().spec().source == others);
    CHECK(app.session.messages().notice().starts_with("2 files were dropped; only one was"));
}

TEST_CASE("An input that has changed since is a warning, not an error") {
    DocumentApp app;
    app.open("scene:sphere");
    const fs::path path = app.folder / "a.sesession";
    SessionFile file = captureSession(app.context);
    file.inputHash = "fnv1a64:0000000000000000";
    REQUIRE(writeSessionFile(path, file).ok());
    app.open(path.string());
    app.document.poll();
    CHECK(app.session.input().phase() == SessionPhase::Ready);
    CHECK(app.session.messages().last().find("has changed") != std::string::npos);
}

TEST_CASE("A session opened at the start warns of other options, and only of these") {
    const auto noticeOf = [](const RunSpec& input) {
        DocumentApp app;
        Options options;
        options.session = SessionFile{};
        options.session->input = {"scene:sphere"};
        options.input = input;
        app.document.begin(options);
        app.waitUntilDone();
        app.document.poll();
        return app.session.messages().notice();
    };
    CHECK(noticeOf({"scene:sphere"}).find("other options") == std::string::npos);
    const RunSpec robust = changed({"scene:sphere"}, specChange({{"rules", "robust"}}));
    CHECK(noticeOf(robust).starts_with("Opened with other options than the session has (robust"));
}

TEST_CASE("A bad session leaves the open input unchanged and gives the reason") {
    DocumentApp app;
    app.open("scene:sphere");
    std::ofstream(app.folder / "bad.sesession") << "{";
    app.open((app.folder / "bad.sesession").string());
    CHECK(app.session.ready());
    CHECK(app.session.input().spec().source == "scene:sphere");
    CHECK(app.session.messages().last().find("bad.sesession") != std::string::npos);
}

TEST_CASE("Notes belong to their input, and wait until it is opened again") {
    DocumentApp app;
    app.open("scene:sphere");
    app.ui.notes = "about the sphere";
    toggleBookmark(app.ui.bookmarks, {3, Stage::Sort, 1});
    app.openBeside("scene:grid");
    CHECK(app.ui.notes.empty());
    CHECK(app.ui.bookmarks.empty());
    app.openBeside("scene:sphere");
    CHECK(app.ui.notes == "about the sphere");
    CHECK(app.ui.bookmarks.size() == 1);
}

TEST_CASE("The first save asks for a name, later ones do not") {
    DocumentApp app;
    app.open("scene:sphere");
    app.document.save();
    CHECK(app.ui.fileBrowser);
    CHECK(app.ui.browser == BrowserTask::SaveSession);
    app.ui.fileBrowser = false;
    const fs::path path = app.folder / "a.sesession";
    app.save(path);
    app.ui.notes = "later";
    app.document.save();
    CHECK_FALSE(app.ui.fileBrowser);
    CHECK(readSessionFile(path).value().annotations.notes == "later");
}

TEST_CASE("Recent files and layout are kept in the state file, and only if there is one") {
    DocumentApp app;
    const fs::path state = app.folder / "state" / "state.json";
    app.open("scene:sphere");
    app.save(app.folder / "before.sesession");
    CHECK(app.ui.recent.empty());
    app.document.keepIn(state, false);
    const fs::path path = app.folder / "a.sesession";
    app.save(path);
    app.ui.layoutPreset = LayoutPreset::Present;
    app.document.poll();
    CHECK(app.ui.recent == std::vector<std::string>{path.string()});
    CHECK(readKeptState(state) == KeptState{LayoutPreset::Present, {path.string()}});
}

TEST_CASE("Edits are captured and restored unchanged") {
    DocumentApp app;
    app.open("scene:sphere");
    const Edits before = captureEdits(app.context);
    app.session.select(5);
    app.camera.set(ViewPreset::Front);
    app.ui.settings.theme = Theme::Light;
    app.ui.notes = "x";
    Edits after = captureEdits(app.context);
    CHECK(after != before);
    applyEdits(before, app.context);
    CHECK(captureEdits(app.context) == before);
}

TEST_CASE("An edge or a triangle that is selected is kept, and comes back by undo") {
    DocumentApp app;
    app.open("scene:sphere");
    const std::vector<Selection> picked = {Selection::ofEdge(9, 4),
                                           Selection::ofTriangle({7, 5, 6})};
    for (const Selection& each : picked) {
        app.session.select(each);
        const fs::path path = app.folder / "picked.sesession";
        DocumentApp other;  // empties the folder
        app.save(path);
        other.open(path.string());
        CHECK(other.session.selection() == each);
        const Edits edits = captureEdits(app.context);
        app.session.select(Selection{});
        applyEdits(edits, app.context);
        CHECK(app.session.selection() == each);
    }
}

TEST_CASE("Bookmarks and notes are unsaved until a session file holds them") {
    DocumentApp app;
    app.open("scene:sphere");
    CHECK(app.document.unsaved().empty());
    app.ui.notes = "odd";
    CHECK_FALSE(app.document.unsaved().empty());
    app.save(app.folder / "noted.sesession");
    CHECK(app.document.unsaved().empty());
    toggleBookmark(app.ui.bookmarks, app.session.address());
    CHECK_FALSE(app.document.unsaved().empty());
    app.openBeside("scene:torus");
    CHECK(app.document.unsaved().empty());
    app.openBeside("scene:sphere");
    CHECK_FALSE(app.document.unsaved().empty());
    app.open((app.folder / "noted.sesession").string());
    CHECK(app.document.unsaved().empty());
}

TEST_CASE("A session older than the up axis opens with z up, a new one keeps its own") {
    DocumentApp app;
    const auto openWith = [&](const std::string& camera) {
        const fs::path path = app.folder / "up.sesession";
        std::ofstream(path) << R"({"format": "spiraling-edge session", "version": 1,)"
                            << R"( "input": {"source": "scene:grid"})" << camera << "}";
        app.open(path.string());
        return app.document.takeCamera();
    };
    const auto old =
        openWith(R"(, "camera": {"target": [0, 0, 0], "distance": 3, "yaw": 10, "pitch": 20})");
    REQUIRE(old.has_value());
    CHECK(old->up == UpAxis::Z);
    CHECK_FALSE(openWith("").has_value());
    // A session without a camera has z up.
    CHECK(app.document.openedSession());
    app.camera.setUp(UpAxis::X);
    const fs::path path = app.folder / "new.sesession";
    app.save(path);
    app.open("scene:sphere");
    CHECK_FALSE(app.document.openedSession());
    app.open(path.string());
    const auto kept = app.document.takeCamera();
    REQUIRE(kept.has_value());
    CHECK(kept->up == UpAxis::X);
}
