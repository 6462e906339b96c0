/// The page with new points as the mouse and the keyboard reach it.
#include <doctest/doctest.h>

#include <cstdlib>
#include <fstream>

#include "driven_app.h"
#include "open_session.h"
#include "run/strings.h"

using namespace se;
using namespace se::view;
using test::differing;
using test::DrivenApp;
using test::OwnFolder;

TEST_CASE("New points: a shape is clicked, a number typed, and each step moves them in the view") {
    DrivenApp app({"--new", "torus", "--steps", "12"});
    if (!app) return;
    const Picture one = app.picture();
    app.press("Right F10");
    CHECK(differing(one, app.picture()) > 200);
    app.clickOn("shape gyroid");
    CHECK(app["growth_source"].starts_with("sample:gyroid"));
    app.press("End");
    CHECK(app.app.context().sampling.growth().picture()->onWalls > 50);
    CHECK(app.app.context().sampling.growth().picture()->quality.variation < 0.10);
    CHECK(app.app.context().sampling.growth().picture()->quality.off < 0.0001);
    // Enter starts with a typed number, also in the next field without input.
    app.clickOn("shape torus");
    app.clickOn("field Points");
    app.type("700");
    app.press("Tab Enter");
    CHECK(app["growth_points"] == "700");
    app.clickOn("field Isovalue");
    app.type("1000");
    app.press("Enter");
    CHECK(app["growth_complaint"].find("no surface") != std::string::npos);
    app.clickOn("shape torus");
    CHECK(app["growth_points"] == "700");
}

TEST_CASE("New points: saved they are those of the command line, used they are a run") {
    const OwnFolder folder;
    DrivenApp app({"--new", "torus", "-n", "600"});
    if (!app) return;
    app.press("End");
    app.clickOn("growth save");
    app.type((folder / "torus").string());
    app.press("Enter");
    CHECK(app["growth_message"].ends_with("torus.ply."));
#ifdef SPIRALING_EDGE_CLI
    const std::string cli = (folder / "cli.ply").string();
    REQUIRE(std::system((SPIRALING_EDGE_CLI " sample torus -n 600 -q -o " + cli).c_str()) == 0);
    CHECK(readText(cli) == readText(folder / "torus.ply"));
#endif
    app.clickOn("growth use");
    CHECK_FALSE(app.ui.growth.open);
    CHECK(app["title"].find("torus, 600") != std::string::npos);
    app.press("F10 Ctrl+N");
    CHECK(app.ui.growth.open);
    app.press("Esc");
    CHECK(app.session.record().pivot == 1);
}

namespace {

/// A ball in a volume of 9 x 9 x 9 bytes, brightest in its middle.
std::string volumeBytes() {
    std::string bytes = "NRRD0004\ntype: uint8\ndimension: 3\nsizes: 9 9 9\nencoding: raw\n\n";
    for (int z = -4; z < 5; ++z) {
        for (int y = -4; y < 5; ++y) {
            for (int x = -4; x < 5; ++x) {
                const int value = 100 - 5 * (x * x + y * y + z * z);
                bytes.push_back(static_cast<char>(value > 0 ? value : 0));
            }
        }
    }
    return bytes;
}

std::string written(const std::filesystem::path& path, std::string_view bytes) {
    std::ofstream(path, std::ios::binary) << bytes;
    return path.string();
}

}  // namespace

TEST_CASE("New points of a volume: an isovalue is asked for, a cut file is refused by its name") {
    const OwnFolder folder;
    const std::string ball = written(folder / "ball.nrrd", volumeBytes());
    const std::string cut = written(folder / "cut.nrrd", volumeBytes().substr(0, 300));
    {
        DrivenApp app({"--new", ball, "-n", "300"});
        if (!app) return;
        CHECK(app["growth_complaint"].find("has no isovalue") != std::string::npos);
    }
    {
        DrivenApp app({"--new", ball, "--iso", "50", "-n", "300", "--steps", "12"});
        CHECK(app["growth_step"] == "12");
        CHECK(app["growth_points"] == "300");
        CHECK(app["growth"] == "paused");
    }
    {
        DrivenApp app({"scene:sphere"});
        app.press("Ctrl+Shift+N");
        CHECK(app.ui.fileBrowser);
        app.type(ball);
        app.press("Enter");
        CHECK_FALSE(app.ui.fileBrowser);
        CHECK(app["growth_complaint"].find("has no isovalue") != std::string::npos);
        app.press("Esc");
        CHECK_FALSE(app.ui.growth.open);
        CHECK(app.session.ready());
    }
    DrivenApp app({"--new", cut, "--iso", "50"});
    CHECK(app["growth_complaint"].find("cut.nrrd") != std::string::npos);
    CHECK(app["growth_complaint"].find("expected") != std::string::npos);
}
