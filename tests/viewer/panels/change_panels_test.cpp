/// The panels of the group Change as the mouse and the keyboard reach them: the doctor, preparing
/// in another way, rules and forks.
#include <doctest/doctest.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <random>

#include "driven_app.h"
#include "open_session.h"
#include "point_files.h"
#include "run/strings.h"
#include "spiraling_edge/io/read_points.h"

using namespace se;
using namespace se::view;
using test::differing;
using test::DrivenApp;
using test::OwnFolder;
using test::writePoints;

namespace {

/// A jittered lattice, which ends at no wall, with a copy, and two normals that are zero.
PointFile flawedLattice() {
    PointFile file;
    for (int y = 0; y < 12; ++y) {
        for (int x = 0; x < 12; ++x) {
            for (int copies = x == 9 && y == 9 ? 2 : 1; copies > 0; --copies) {
                file.position.emplace_back(x + 0.11 * std::sin(7 * x + 3 * y),
                                           y + 0.13 * std::sin(5 * x + 11 * y), 0.0);
                file.normal.emplace_back(0.0, 0.0, x == 4 && y < 2 ? 0.0 : 1.0);
            }
        }
    }
    return file;
}

/// Two layers of a torus, as two scans that are not registered leave; without normals.
std::string twoLayers(const std::filesystem::path& path) {
    constexpr double kTurn = 6.283185307179586;
    std::mt19937 chance(4);
    const auto share = [&] { return static_cast<double>(chance()) / 4294967296.0; };
    std::ofstream file(path);
    for (int layer = 0; layer < 2; ++layer) {
        for (int made = 0; made < 1500;) {
            const double a = kTurn * share();
            const double b = kTurn * share();
            if (1.4 * share() > 1.0 + 0.4 * std::cos(b)) continue;
            const double r = 0.4 + 0.07 * layer;
            file << (1 + r * std::cos(b)) * std::cos(a) << ' '
                 << (1 + r * std::cos(b)) * std::sin(a) << ' ' << r * std::sin(b) << '\n';
            ++made;
        }
    }
    return path.string();
}

}  // namespace

TEST_CASE("Doctor: a finding marks its place in the rail, a click on it shows its points") {
    const OwnFolder folder;
    {
        DrivenApp sound({"scene:torus"});
        if (!sound) return;
        CHECK(sound["findings"] == "[]");
        CHECK_FALSE(sound.shows("news Input"));
    }
    DrivenApp app({writePoints(folder / "flawed.xyz", flawedLattice())}, {1600, 980});
    CHECK(app["findings"] == R"(["duplicates","zero_normals","open_border"])");
    CHECK(app["aside"] == R"({"duplicates":1})");
    CHECK(app["task"] != "Input");
    CHECK(app.shows("news Input"));
    app.part("Doctor");
    CHECK_FALSE(app.shows("news Input"));
    CHECK(app["marked"] == "0");
    app.clickOn("finding zero_normals");
    CHECK(app["marked"] == "2");
    const Picture marked = app.picture();
    app.clickOn("finding zero_normals");  // again: the marks are cleared
    CHECK(app["marked"] == "0");
    CHECK(differing(marked, app.picture()) > 100);
    app.clickOn("finding duplicates");
    CHECK(app["marked"] == "1");
    app.press("Esc");
    CHECK(app["marked"] == "0");
    app.clickOn("rail Change");
    CHECK(app["task"] == "Change");
    app.command("doctor");
    CHECK(app["part"] == "Doctor");
}

TEST_CASE(
    "Verdict: a line about points set aside leads to the panel Input, on flawed inputs alone") {
    const OwnFolder folder;
    {
        DrivenApp sound({"scene:torus", "--goto", "100%"});
        if (!sound) return;
        sound.part("Verdict");
        CHECK(sound.shows("verdict title"));
        CHECK_FALSE(sound.shows("verdict input"));
    }
    DrivenApp app({writePoints(folder / "flawed.xyz", flawedLattice())}, {1600, 980});
    app.part("Verdict");
    app.clickOn("verdict input");
    CHECK(app["task"] == "Input");
    CHECK(app["part"] == "Doctor");
}

TEST_CASE("Doctor: the record of the input has what its reader noted, and the viewpoint") {
    const OwnFolder folder;
    std::ofstream file(folder / "scan.pcd");
    file << "VERSION .7\nFIELDS x y z rings\nSIZE 4 4 4 4\nTYPE F F F F\nCOUNT 1 1 1 3\n"
            "WIDTH 30\nHEIGHT 1\nVIEWPOINT 0.5 -2 9 1 0 0 0\nPOINTS 30\nDATA ascii\n";
    for (int i = 0; i < 30; ++i) file << i % 6 + 0.1 * std::sin(i) << ' ' << i / 6 << " 0 1 2 3\n";
    file.close();
    DrivenApp app({(folder / "scan.pcd").string()}, {1600, 980});
    if (!app) return;
    app.part("Doctor");
    CHECK(app.shows("fact viewpoint 0.5 -2 9, the place of the sensor"));
    CHECK(app.shows("fact left out: field rings"));
}

TEST_CASE(
    "Doctor: one finding is fixed by a click, undone and done again, the file used as it is") {
    const OwnFolder folder;
    DrivenApp app({writePoints(folder / "flawed.xyz", flawedLattice())}, {1600, 980});
    if (!app) return;
    const std::size_t points = app.session.model().points.size();
    const auto isFixed = [&] {
        return app["cures"] == R"(["zero_normals"])" && app["findings"] == R"(["open_border"])" &&
               app.session.model().points.size() == points - 1;
    };
    const auto isAsItWas = [&] {
        return app["cures"] == "[]" && app.session.model().points.size() == points;
    };
    app.goTo("20");
    app.part("Doctor");
    app.clickOn("fix zero_normals");
    CHECK(isFixed());
    CHECK(app.session.atEnd());
    CHECK(app["aside"] == R"({"zero_normals":1})");
    CHECK(app["mended"] ==
          R"(["1 exact copy dropped","2 normals that were zero or not finite derived"])");
    app.press("Esc Ctrl+Z");
    CHECK(isAsItWas());
    app.press("Ctrl+Y");
    CHECK(isFixed());
    app.clickOn("doctor as it is");
    CHECK(isAsItWas());
    app.press("Esc Ctrl+Z");
    CHECK(isFixed());
    app.press("Ctrl+Z");
    CHECK(isAsItWas());
    // Points dropped by a fix come back by a click.
    app.clickOn("fix duplicates");
    CHECK(app["cures"] == R"(["duplicates"])");
    app.clickOn("return duplicates");
    CHECK(isAsItWas());
    CHECK(app.session.atEnd());
    app.clickOn("copy zero_normals");
    CHECK(app["notice"] == "Copied the command.");
}

TEST_CASE(
    "Doctor: normals are scaled and flipped together, and the prepared choice replaces that") {
    const OwnFolder folder;
    PointFile flipped = test::spiralSphere(900);
    for (Vec3& normal : flipped.normal) normal *= normal.z > 0.6 ? -1.0 : 2.0;
    DrivenApp app({writePoints(folder / "flipped.xyz", flipped)}, {1600, 980});
    if (!app) return;
    CHECK(app["findings"].find(R"("unscaled_normals")") != std::string::npos);
    CHECK(app["findings"].find(R"("flipped_normals")") != std::string::npos);
    app.command("doctor");
    app.clickOn("doctor fix all");
    CHECK(app["mended"].find(" normals scaled to unit length\"") != std::string::npos);
    CHECK(app["mended"].find(" normals flipped\"") != std::string::npos);
    CHECK(app["findings"] == "[]");
    app.press("Ctrl+Shift+R");
    app.reach("region column", "prepare From the input##m");
    app.clickOn("prepare ok");
    CHECK(app["cures"].find("flipped_normals") == std::string::npos);
}

TEST_CASE("Doctor: two layers are thinned to one at the second click, since most points go") {
    const OwnFolder folder;
    DrivenApp app({twoLayers(folder / "layers.xyz"), "--rules", "robust"}, {1600, 980});
    if (!app) return;
    CHECK(app["findings"].find("two_layers") != std::string::npos);
    CHECK(app["verdict"] != "the mesh is sound");
    app.part("Doctor");
    app.clickOn("fix two_layers");
    CHECK(app["cures"] == "[]");
    app.clickOn("fix two_layers");
    CHECK(app["cures"] == R"(["two_layers"])");
    CHECK(app["findings"].find("two_layers") == std::string::npos);
    CHECK(app["verdict"] == "the mesh is sound");
}

TEST_CASE("Points set aside for noise are seen while their layer is on, and return by a click") {
    const OwnFolder folder;
    PointFile noisy = test::spiralSphere(600);
    std::mt19937 chance(5);
    for (Vec3& position : noisy.position) {
        double sum = -1.5;
        for (int i = 0; i < 3; ++i) sum += static_cast<double>(chance()) / 4294967296.0;
        position *= 1.0 + 0.18 * sum;
    }
    DrivenApp app({writePoints(folder / "noisy.xyz", noisy), "--rules", "robust"});
    if (!app) return;
    const std::string aside = app["aside"];
    CHECK(aside.starts_with(R"({"noise":)"));
    app.command("doctor");
    const Picture marks = app.picture();
    app.clickOn("layers menu");
    app.clickOn("layer aside");
    CHECK(app["pins"].find(R"("aside":"off")") != std::string::npos);
    CHECK(differing(marks, app.picture()) > 100);
    app.clickOn("layer aside");
    app.press("Esc");
    app.part("Doctor");
    app.clickOn("return noise");
    CHECK(app["aside"] == "{}");
    CHECK(app["choices"] == R"(["noise=off"])");
    app.press("Ctrl+Z");
    CHECK(app["aside"] == aside);
}

#ifdef SPIRALING_EDGE_CLI

namespace {

/// Saves the mesh by Ctrl+E. True if it is byte for byte what `run` with `options` writes.
bool savesAs(DrivenApp& app, const std::string& input, const std::string& options) {
    const std::string saved = input + ".ply";
    const std::string expected = input + ".expected.ply";
    app.press("Ctrl+E Ctrl+A");
    app.type(saved);
    app.press("Enter");
    CHECK_FALSE(app.ui.fileBrowser);
    const std::string command = SPIRALING_EDGE_CLI " run " + input + options + " -q -o " + expected;
    CHECK(std::system((command + " 2>/dev/null").c_str()) == 0);
    return readText(saved).value_or("") == readText(expected);
}

/// A noisy ball without normals, the noise as wide as a fifth of the spacing.
PointFile noisyBall() {
    PointFile ball = test::spiralSphere(2000);
    for (std::size_t p = 0; p < ball.position.size(); ++p)
        ball.position[p] *= 1.0 + 0.016 * std::sin(static_cast<double>(p * p % 7919));
    ball.normal.clear();
    return ball;
}

}  // namespace

TEST_CASE("Fix and Save mesh write what run --best writes") {
    const OwnFolder folder;
    std::vector<std::string> inputs = {
        writePoints(folder / "sheet.xyz", test::holedSheet(20, 20)),
        writePoints(folder / "ball.xyz", noisyBall()),
    };
#ifdef SPIRALING_EDGE_SHARED_DATA
    inputs.push_back(
        writePoints(folder / "elephant.xyz",
                    readPoints(SPIRALING_EDGE_SHARED_DATA "/points/elephant.ply").value()));
#else
    MESSAGE("skipped: no shared scan");
#endif
    int fixes = 0;
    int saved = 0;
    for (const std::string& input : inputs) {
        CAPTURE(input);
        DrivenApp app({input}, {1600, 980});
        if (!app) return;
        CHECK(app.session.atEnd());
        app.press("F8");
        const std::string change = app["trial_best"];
        if (!change.empty()) {
            app.clickOn("verdict fix");
            CHECK(app["notice"].find("The place that was shown ") != std::string::npos);
            ++fixes;
        }
        // Points that the best change drops are not in the file that the window saves.
        if (change.find("without") != std::string::npos) continue;
        CHECK(savesAs(app, input, " --best"));
        ++saved;
    }
    CHECK(fixes > 0);
    CHECK(saved > 0);
}

TEST_CASE("The buttons of the verdict stay in place while trials of other settings arrive") {
    DrivenApp app({"scene:noise", "--goto", "100%"});
    if (!app) return;
    const glm::vec2 save = app.in("verdict save");
    const glm::vec2 worst = app.in("verdict worst");
    if (app.shows("verdict try")) app.clickOn("verdict try");
    app.settle();
    REQUIRE(app.session.trials().ended());
    CHECK(app.in("verdict save").y == save.y);
    CHECK(app.in("verdict worst").y == worst.y);
}

TEST_CASE("Holes closed in the part Verdict are those that holewidth closes") {
    const OwnFolder folder;
    const std::string input = writePoints(folder / "sheet.xyz", test::holedSheet(20, 20));
    DrivenApp app({input}, {1600, 980});
    if (!app) return;
    app.clickOn("verdict close holes");
    app.type("12");
    app.press("Enter");
    CHECK(savesAs(app, input, " --rules robust --rule holewidth=12"));
}

#endif

TEST_CASE("Prepare: fields are typed, choices clicked, and the earlier ones stay") {
    DrivenApp app({"sample:plane,n=400"});
    if (!app) return;
    const auto spec = [&] { return app.session.input().spec(); };
    CHECK(app["derived"] == R"(["neighbors"])");
    app.goTo("p12");
    app.press("Ctrl+Shift+R");
    CHECK(app.ui.prepare.open);
    CHECK(app["typing"] == "true");
    app.type("0");
    app.press("Enter");
    CHECK(app.ui.prepare.open);
    app.retype("prepare count", "9");
    app.reach("region column", "prepare Derived from the positions");
    app.reach("region column", "prepare The box around all points");
    app.clickOn("prepare ok");
    CHECK_FALSE(app.ui.prepare.open);
    CHECK(app["derived"] == R"(["neighbors","normals","types"])");
    CHECK(app.session.atStart());
    CHECK(app.session.selected() == 12);
    app.press("Ctrl+Shift+R Esc Esc");
    CHECK_FALSE(app.ui.prepare.open);
    CHECK(app.session.selected() == 12);
    // By keyboard alone: the first field has it, Enter prepares.
    app.press("Ctrl+Shift+R");
    app.type("7");
    app.press("Enter");
    CHECK(spec().neighbors.reach == decltype(NeighborOptions::reach){KNearest{7}});
    CHECK(app["derived"] == R"(["neighbors","normals","types"])");
    app.press("Ctrl+Shift+R");
    app.reach("region column", "prepare spacings");
    app.type("1.5");
    app.press("Enter");
    CHECK_FALSE(app.ui.prepare.open);
    // Normals that face a scanner are flipped ones; it takes three numbers.
    app.press("Ctrl+Shift+R");
    app.reach("region column", "prepare From the input##m");
    app.reach("region column", "prepare scanner");
    app.type("0");
    app.press("Enter");
    CHECK(app.ui.prepare.open);
    app.reach("region column", "prepare scanner");
    for (const auto& [share, text] : {std::pair{0.16F, "5"}, std::pair{0.84F, "-3"}}) {
        app.click(app.in("prepare scanner", share, 0.5F));
        app.type(text);
    }
    app.press("Enter");
    CHECK_FALSE(app.ui.prepare.open);
    CHECK(spec().scanner == Vec3(5.0, 0.0, -3.0));
    CHECK(spec().normals == NormalSource::Oriented);
    CHECK(spec().neighbors.reach == decltype(NeighborOptions::reach){WithinSpacings{1.5}});
}

TEST_CASE("Rules: a filter finds a switch, a click runs again, its reset takes it back") {
    DrivenApp app({"scene:torus", "--goto", "60.sphere.1"}, {1600, 980});
    if (!app) return;
    app.command("rules switches");
    CHECK(app.shows("effect tie"));
    app.clickOn("rules filter");
    app.type("walls passed");
    app.clickOn("rule walls");
    CHECK(app["choices"] == R"(["walls=off"])");
    app.clickOn("reset walls");
    CHECK(app["choices"] == "[]");
    app.retype("rules filter", "maxgap");
    app.retype("rule maxgap", "95");
    app.press("Enter");
    CHECK(app["choices"] == R"(["maxgap=95"])");
    app.press("Esc Ctrl+Z");
    CHECK(app["message"].starts_with("Undone: rule maxgap."));
    app.press("Ctrl+Y");
    app.clickOn("rules reset all");
    CHECK(app["choices"] == "[]");
}

TEST_CASE("What if: a fork by a click and back to the true run, a wrong list is refused") {
    DrivenApp app({"scene:torus", "--goto", "60.emit.1"}, {1600, 980});
    if (!app) return;
    app.command("what if forks");
    app.clickOn("what if here");
    CHECK(app["what_if"].starts_with("[\"60.guard drop "));
    // Beside the run without it, by one click.
    app.press("Ctrl+D");
    app.clickOn("compare true run");
    CHECK(app["compare_other"] == "no what-ifs");
    app.press("Ctrl+D");
    app.clickOn("true run");
    CHECK(app["what_if"] == "[]");
    app.reach("region column", "what if list");
    app.press("Ctrl+A");
    app.type("1 1");
    app.reach("region column", "what if neighbors");
    CHECK(app["message"].find("Point 1 is in the list twice.") != std::string::npos);
}
