/// The tool for a piece of a scan: keeping and leaving out enclosed points, undo, sessions.
#include "document/piece_actions.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>

#include "commands/commands.h"
#include "document/mesh_saving.h"
#include "headless_app.h"
#include "run/strings.h"

using namespace se;
using namespace se::view;

namespace {

constexpr glm::vec2 kPieceView(640.0F, 480.0F);
constexpr std::array<glm::vec2, 4> kRightHalf{
    {{320.0F, 0.0F}, {640.0F, 0.0F}, {640.0F, 480.0F}, {320.0F, 480.0F}}};
constexpr std::array<glm::vec2, 4> kNowhere{
    {{0.0F, 0.0F}, {1.0F, 0.0F}, {1.0F, 1.0F}, {0.0F, 1.0F}}};

/// The tool is on over a sphere.
struct PieceApp : test::HeadlessApp {
    std::size_t all = 0;

    explicit PieceApp(const std::string& name) : HeadlessApp(name) {
        document.open("scene:sphere");
        waitUntilDone();
        REQUIRE(session.ready());
        all = session.model().points.size();
        runCommand(*findCommand("edit.piece"), context);
    }
    void settle() {
        waitUntilDone();
        document.poll();
        session.waitUntilDone();
    }
    bool press(const char* key) {
        const bool taken = runOnPieceTool(*keyFromString(key), context);
        settle();
        return taken;
    }
    std::size_t count() const { return session.model().points.size(); }
};

}  // namespace

TEST_CASE("Enclosed points are counted and marked at all depths, a drag in the void clears them") {
    PieceApp app("piece-enclose");
    enclosePoints(app.context, kPieceView, kRightHalf);
    const std::vector<Index>& inside = app.ui.piece.inside;
    const Model& model = app.session.model();
    CHECK(inside.size() > app.all / 3);
    CHECK(inside.size() < 2 * app.all / 3);
    const auto facing = std::count_if(inside.begin(), inside.end(), [&](Index p) {
        const CameraMatrices camera = app.camera.matrices(kPieceView.x / kPieceView.y);
        return glm::dot(camera.eye - model.place[p], model.normal[p]) >= 0.0F;
    });
    CHECK(facing > 0);
    CHECK(static_cast<std::size_t>(facing) < inside.size());
    CHECK(app.session.highlights().marked().size() == inside.size());
    CHECK(insideText(1) == "1 point inside");
    enclosePoints(app.context, kPieceView, kNowhere);
    CHECK(app.ui.piece.inside.empty());
    CHECK(app.session.highlights().marked().empty());
    // Nothing is run without points inside.
    CHECK(app.press("Enter"));
    CHECK(app.count() == app.all);
    CHECK(app.ui.piece.on);
}

TEST_CASE("Enter keeps the enclosed points alone, the run goes to its end, the camera stays") {
    PieceApp app("piece-keep");
    const CameraPose camera = app.camera.pose();
    enclosePoints(app.context, kPieceView, kRightHalf);
    const std::size_t inside = app.ui.piece.inside.size();
    const Index first = app.ui.piece.inside.front();
    CHECK(app.press("Enter"));
    CHECK(app.count() == inside);
    CHECK(app.session.model().numberInPiece(0) == first);
    CHECK(app.session.atEnd());
    CHECK(app.camera.pose() == camera);
    CHECK_FALSE(app.ui.piece.on);
    CHECK(app.session.highlights().marked().empty());
    CHECK(app.session.messages().last().find("Left out: ") != std::string::npos);
    CHECK_FALSE(app.press("Enter"));
}

TEST_CASE("Delete leaves the enclosed points out, a second time those of the rest") {
    PieceApp app("piece-leave");
    enclosePoints(app.context, kPieceView, kRightHalf);
    const std::size_t inside = app.ui.piece.inside.size();
    CHECK(app.press("Delete"));
    CHECK(app.count() == app.all - inside);
    runCommand(*findCommand("edit.piece"), app.context);
    constexpr std::array<glm::vec2, 4> kTopLeft{
        {{0.0F, 0.0F}, {320.0F, 0.0F}, {320.0F, 240.0F}, {0.0F, 240.0F}}};
    enclosePoints(app.context, kPieceView, kTopLeft);
    const std::size_t more = app.ui.piece.inside.size();
    REQUIRE(more > 0);
    app.press("Delete");
    CHECK(app.count() == app.all - inside - more);
    REQUIRE(app.session.model().aside.size() == 1);
    bringBack(app.context, app.session.model().aside.front());
    app.settle();
    CHECK(app.count() == app.all);
    CHECK(app.session.model().aside.empty());
}

TEST_CASE("All points cannot be left out, Esc ends the tool") {
    PieceApp app("piece-all");
    constexpr std::array<glm::vec2, 4> kAll{
        {{-1e4F, -1e4F}, {1e4F, -1e4F}, {1e4F, 1e4F}, {-1e4F, 1e4F}}};
    enclosePoints(app.context, kPieceView, kAll);
    CHECK(app.ui.piece.inside.size() == app.all);
    app.press("Delete");
    CHECK(app.count() == app.all);
    CHECK(app.session.messages().last() == "No point would be left to run with.");
    CHECK(app.ui.piece.on);
    runCommand(*findCommand("help.leave"), app.context);
    CHECK_FALSE(app.ui.piece.on);
    CHECK(app.session.highlights().marked().empty());
}

TEST_CASE("Undo brings the points back, with the what-ifs that were removed with them") {
    PieceApp app("piece-undo");
    RunSpec moved = app.session.input().spec();
    moved.whatIf = {whatIfFromText("2 move 30 0.01 -0.02 1.03").value()};
    app.document.rerun(moved);
    app.settle();
    const Edits before = captureEdits(app.context);
    REQUIRE(before.input.whatIf.size() == 1);
    enclosePoints(app.context, kPieceView, kRightHalf);
    app.press("Delete");
    const Edits after = captureEdits(app.context);
    CHECK(after.input.whatIf.empty());
    CHECK(describeChange(before, after) == "points left out");
    applyEdits(before, app.context);
    app.settle();
    CHECK(app.count() == app.all);
    CHECK(captureEdits(app.context).input == before.input);
}

TEST_CASE("A session keeps the points left out, a command line cannot, another input forgets") {
    PieceApp app("piece-session");
    enclosePoints(app.context, kPieceView, kRightHalf);
    app.press("Delete");
    const IndexRanges leftOut = app.session.input().spec().leftOut;
    REQUIRE_FALSE(leftOut.empty());
    const MeshCommand command = meshCommand(app.session, {"m.ply"});
    CHECK(command.text.empty());
    CHECK(command.note.find("left out") != std::string::npos);
    const std::string path = (app.folder / "a.sesession").string();
    app.document.saveAs(path);
    const std::string text = *readText(path);
    CHECK(text.find("\"left_out\": \"" + rangesText(leftOut) + "\"") != std::string::npos);
    app.document.open("scene:sphere");
    app.waitUntilDone();
    CHECK(app.count() == app.all);
    app.document.open(path);
    app.waitUntilDone();
    CHECK(app.session.input().spec().leftOut == leftOut);
    CHECK(app.count() < app.all);
    std::string broken = text;
    broken.replace(broken.find(rangesText(leftOut)), rangesText(leftOut).size(), "9..2");
    const auto read = sessionFromJson(broken, "b", app.folder);
    REQUIRE_FALSE(read);
    CHECK(read.error().message.find("options.left_out") != std::string::npos);
}

TEST_CASE("Noise comes back by its rule, points dropped by a fix by taking back the fix") {
    PieceApp app("piece-return");
    app.document.rerun(withSet({}, "robust"));
    app.settle();
    bringBack(app.context, {Aside::Noise});
    const RuleSetting& noise = *findRuleSetting("noise");
    CHECK(valueOf(app.session.input().rules(), noise) == 0.0);
    app.settle();
    app.document.runWithFixes({"duplicates", "flipped_normals"});
    app.settle();
    bringBack(app.context, {Aside::LeftOut, "duplicates"});
    CHECK(app.session.input().opening().fixes == std::vector<std::string>{"flipped_normals"});
}
