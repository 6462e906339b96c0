#include "document/mesh_saving.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>

#include "headless_app.h"
#include "jobs/mesh_export.h"
#include "run/strings.h"
#include "spiraling_edge/base/shell_word.h"
#include "spiraling_edge/io/write_mesh.h"
#include "spiraling_edge/run/reading.h"
#include "spiraling_edge/scenes/scenes.h"
#include "spiraling_edge/stepper/stepper.h"

using namespace se;
using namespace se::view;
namespace fs = std::filesystem;

namespace {

constexpr const char* kSphere = "scene:sphere";

std::string textOf(const RunSpec& spec, const MeshTarget& target = {"m.ply", false}) {
    return meshCommand(spec, target).text;
}

RunSpec specOf(std::string source) {
    RunSpec spec;
    spec.source = std::move(source);
    return spec;
}

}  // namespace

TEST_CASE("The command names the input and the mesh, each as one word of a shell") {
    CHECK(textOf(specOf(kSphere)) == "spiraling-edge run scene:sphere -o m.ply");
    CHECK(textOf(specOf(kSphere), {"/a b/it's.obj", true}) ==
          "spiraling-edge run scene:sphere --used-points -o '/a b/it'\\''s.obj'");
    CHECK(textOf(specOf(kSphere), {"m.ply", true, true}) ==
          "spiraling-edge run scene:sphere --used-points --fault-fields -o m.ply");
    CHECK(textOf(specOf(kSphere), {"-m.ply", false}) ==
          "spiraling-edge run scene:sphere -o ./-m.ply");
    CHECK(textOf(specOf("/a\n\x1b.ply")) ==
          "spiraling-edge run \"$(printf '/a\\012\\033.ply')\" -o m.ply");
    // Only PLY holds columns.
    CHECK(textOf(specOf(kSphere), {"m.stl", false, true}) ==
          "spiraling-edge run scene:sphere -o m.stl");
    const std::string here = textOf(specOf("odd $name.ply"));
    CHECK(here ==
          "spiraling-edge run '" + (fs::current_path() / "odd $name.ply").string() + "' -o m.ply");
}

TEST_CASE("The command of a mesh that replaces the points says so") {
    const test::OwnFolder folder;
    const fs::path points = folder / "p.ply";
    std::ofstream(points) << "points";
    fs::create_symlink("p.ply", folder / "link.ply");
    const std::string run = "spiraling-edge run " + shellQuoted(points.string()) + " -o ";
    for (const fs::path& mesh : {points, folder / "link.ply"}) {
        CHECK(textOf(specOf(points.string()), {mesh.string()}) ==
              run + shellQuoted(mesh.string()) + " --force");
    }
    CHECK(textOf(specOf(points.string()), {"m.ply"}) == run + "m.ply");
}

TEST_CASE("The command has every option in which the input differs from the defaults") {
    RunSpec spec = specOf(kSphere);
    spec.rules = "robust";
    spec.choices = {ruleValueFromText("maxgap=100").value(), ruleValueFromText("flip=off").value()};
    spec.whatIf = {whatIfFromText("137.sphere keep 812").value()};
    spec.neighbors = {WithinRadius{0.25}, true, 0, true, true};
    spec.rim = true;
    spec.normals = NormalSource::Derived;
    spec.walls = {WallChoice::From::Box, {{-1, 0, 0}, {1, 2, 0.5}}};
    CHECK(textOf(spec) ==
          "spiraling-edge run scene:sphere --rules robust --rule maxgap=100 --rule flip=off "
          "--what-if '137.sphere keep 812' --radius 0.25 --symmetric "
          "--derive-normals --box=-1,0,0,1,2,0.5 --derive-rim -o m.ply");
    spec = specOf(kSphere);
    spec.neighbors = {WithinSpacings{1.6}, true, 0, true, false};
    spec.normals = NormalSource::Oriented;
    spec.walls.from = WallChoice::From::Around;
    spec.scanner = Vec3(-1, 0.5, 2);
    CHECK(textOf(spec) ==
          "spiraling-edge run scene:sphere --reach 1.6 --orient --scanner=-1,0.5,2 --box auto "
          "-o m.ply");
}

TEST_CASE("A piece is read by the first command") {
    RunSpec spec = specOf("/in/a.ply");
    spec.piece.crop = changed({}, specChange({{"crop", "-1,0,0,1,2,0.5"}})).piece.crop;
    spec.piece.thin = 0.25;
    CHECK(textOf(spec) ==
          "spiraling-edge run /in/a.ply --crop=-1,0,0,1,2,0.5 --thin 0.25 -o m.ply");
    spec.fixes = {"duplicates"};
    CHECK(textOf(spec) ==
          "{ spiraling-edge doctor /in/a.ply --crop=-1,0,0,1,2,0.5 --thin 0.25 -q --fix "
          "a-fixed.ply; [ $? -le 1 ]; } && spiraling-edge run a-fixed.ply -o m.ply");
}

TEST_CASE("Sampled points are written first, beside the mesh") {
    const MeshCommand command =
        meshCommand(specOf("sample:torus,n=400,seed=2"), {"/out/m.ply", false});
    CHECK(command.text ==
          "spiraling-edge sample torus -n 400 --seed 2 -o /out/torus-400.ply && "
          "spiraling-edge run /out/torus-400.ply -o /out/m.ply");
    CHECK(command.note.find("/out/torus-400.ply") != std::string::npos);
    const MeshCommand stopped = meshCommand(specOf("sample:torus,n=400,steps=7"), {"m.ply", false});
    CHECK(stopped.text.empty());
    CHECK(stopped.note.find("Save new points") != std::string::npos);
}

TEST_CASE("A repair by the doctor is a command before, an option chosen by it an option") {
    RunSpec spec = specOf("/in/a.ply");
    spec.fixes = {"flipped_normals", "duplicates", "unscaled_normals", "near_duplicates",
                  "short_lists"};
    const MeshCommand command = meshCommand(spec, {"/out/m.ply", false});
    CHECK(command.text ==
          "{ spiraling-edge doctor /in/a.ply -q --fix /out/a-fixed.ply; [ $? -le 1 ]; } && "
          "{ spiraling-edge doctor /out/a-fixed.ply -q --fix /out/a-fixed-2.ply --drop "
          "near_duplicates; [ $? -le 1 ]; } && "
          "spiraling-edge run /out/a-fixed-2.ply --neighbors 12 --orient -o /out/m.ply");
    CHECK(command.note.find("a-fixed-2.ply") != std::string::npos);
}

TEST_CASE("Points from standard input have no command: a sentence names the step needed first") {
    const MeshCommand command = meshCommand(specOf("-"), {"m.ply", false});
    CHECK(command.text.empty());
    CHECK(command.note.find("standard input") != std::string::npos);
}

TEST_CASE("A what-if without effect is refused by the command line, with a sentence") {
    test::HeadlessApp app("refused-test");
    RunSpec spec = specOf(kSphere);
    spec.whatIf = {whatIfFromText("99999.sphere keep 1").value()};
    app.session.open(spec);
    app.session.waitUntilDone();
    REQUIRE(app.session.ready());
    const MeshCommand command = meshCommand(app.session, {"m.ply", false});
    CHECK(command.text.empty());
    CHECK(command.note.find("99999.sphere keep 1") != std::string::npos);
}

TEST_CASE("The command is copied without the dialog as well: for a file named after the input") {
    test::HeadlessApp app("copied-test");
    app.session.open(specOf(kSphere));
    app.session.waitUntilDone();
    app.mesh.copyCommand({});
    CHECK(app.ui.clipboard.copied() == "spiraling-edge run scene:sphere -o sphere-mesh.ply");
    CHECK(app.session.messages().last() == "Copied the command.");
}

#ifdef SPIRALING_EDGE_CLI

namespace {

/// Runs the copied command as a shell does, with the program of this build.
int runInShell(const std::string& command) {
    const std::string folder = fs::path(SPIRALING_EDGE_CLI).parent_path().string();
    const std::string whole = "PATH=" + shellQuoted(folder) + ":$PATH; { " + command + "; } 2>&1";
    return std::system(("sh -c " + shellQuoted(whole) + " >/dev/null").c_str());
}

/// The first test of a run that a what-if can invert.
WhatIf turnedTest(const RunSpec& spec) {
    LoadProgress progress;
    const auto model = test::loadModel(spec, progress).value();
    EventLog log;
    Stepper stepper(model->points, model->params, &log);
    stepper.run();
    for (const Event& event : log.events()) {
        if (event.address.stage != Stage::Sphere || verdictOf(event) != Verdict::Removed) continue;
        return whatIfFromText(std::to_string(event.address.pivot) + ".sphere keep " +
                              std::to_string(testedPoint(event)))
            .value();
    }
    REQUIRE(false);
    return {};
}

/// Compares the file saved by the viewer with that of the copied command; they must be equal.
void checkReproduced(const RunSpec& spec, const char* name = "m.ply", bool usedOnly = false,
                     bool faultFields = false) {
    test::HeadlessApp app("reproduced test");  // a space in the path
    app.session.open(spec);
    app.session.waitUntilDone();
    REQUIRE_MESSAGE(app.session.ready(), app.session.input().error());
    const MeshTarget target{(app.folder / name).string(), usedOnly, faultFields};
    const FinishedMesh mesh =
        finishMesh(app.session.model(), *app.session.input().file(), app.session.runEnd());
    REQUIRE(!mesh.triangles->empty());
    REQUIRE(saveMesh(app.session.model(), mesh, target).ok());
    const std::optional<std::string> saved = readText(target.path);
    fs::remove(target.path);
    const MeshCommand command = meshCommand(app.session, target);
    CAPTURE(command.text);
    REQUIRE(!command.text.empty());
    CHECK(runInShell(command.text) == 0);
    CHECK(saved.has_value());
    CHECK(readText(target.path) == saved);
}

/// A scene as a file with floats, colors, and the effect of `change`.
template <typename Change>
struct SceneFile {
    fs::path path = test::ownPlace("the points.ply");
    SceneFile(const char* scene, Change change) {
        PointFile file = findScene(scene)->build();
        file.neighbors = {};
        file.positionType = file.normalType = ScalarType::Float;
        Attribute red{"red", ScalarType::UInt8, {}};
        for (std::size_t p = 0; p < file.position.size(); ++p)
            red.values.push_back(static_cast<double>(p % 256));
        file.attributes.push_back(red);
        change(file);
        REQUIRE(writeMeshPly(path, file, {}).ok());
    }
    ~SceneFile() { fs::remove(path); }
    RunSpec spec() const { return specOf(path.string()); }
};
template <typename Change>
SceneFile(const char*, Change) -> SceneFile<Change>;

}  // namespace

TEST_CASE("The copied command writes the same bytes: scenes, all formats, used points") {
    for (const char* name : {"m.ply", "m.obj", "m.off", "m.stl", "m.glb"}) {
        CAPTURE(name);
        checkReproduced(specOf("scene:sheet"), name);
        checkReproduced(specOf("scene:stranded-point"), name, true);
        checkReproduced(specOf("scene:stranded-point"), name, true, true);
    }
}

TEST_CASE("The copied command writes the same bytes: a file with rules, lists and what-ifs") {
    const SceneFile file("sphere", [](PointFile&) {});
    RunSpec spec = file.spec();
    spec.rules = "corrected";
    spec.choices = {ruleValueFromText("maxgap=100.5").value()};
    spec.neighbors = {KNearest{9}, true, 0, true, true};
    checkReproduced(spec);
    spec.neighbors = {WithinSpacings{1.7}, true, 0, true, false};
    checkReproduced(spec);
    spec.neighbors = {WithinRadius{0.31}, true, 0, true, false};
    spec = changed(spec, specChange({{"switches", "opposing=off"}, {"switches", "noise=off"}}));
    checkReproduced(spec);
    spec = file.spec();
    spec.whatIf = {turnedTest(spec)};
    checkReproduced(spec);
    spec.whatIf = {whatIfFromText("2 move 30 0.01 -0.02 1.03").value()};
    checkReproduced(spec);
}

TEST_CASE("The copied command writes the same bytes: normals, walls and rims that are derived") {
    RunSpec spec = specOf("scene:sheet");
    spec.walls.from = WallChoice::From::Around;
    checkReproduced(spec);
    spec.walls = {WallChoice::From::Box, {{-1.5, -1.0, -1.0}, {1.0, 1.0, 1.0}}};
    spec.rim = true;
    spec.normals = NormalSource::Derived;
    checkReproduced(spec, "m.ply", true);
    const SceneFile flipped("sphere", [](PointFile& file) {
        for (std::size_t p = 0; p < file.normal.size(); p += 7) file.normal[p] = -file.normal[p];
    });
    spec = flipped.spec();
    spec.normals = NormalSource::Oriented;
    checkReproduced(spec);
    const SceneFile bare("sphere", [](PointFile& file) { file.normal.clear(); });
    checkReproduced(bare.spec());
}

TEST_CASE("The copied command writes the same bytes: sampled points, and repaired points") {
    checkReproduced(specOf("sample:torus,n=300,seed=2"));
    const SceneFile flawed("sphere", [](PointFile& file) {
        for (Vec3& normal : file.normal) normal *= normal.z > 0.8 ? -1.0 : 2.7;
        file.position.push_back(file.position[3]);
        file.normal.push_back(file.normal[3]);
        file.attributes[0].values.push_back(0.0);
        if (file.hasTypes()) file.type.push_back(0);
    });
    RunSpec spec = flawed.spec();
    for (const std::vector<std::string>& fixes :
         {std::vector<std::string>{"duplicates"},
          std::vector<std::string>{"unscaled_normals", "flipped_normals"},
          std::vector<std::string>{"near_duplicates", "short_lists", "unsymmetric_lists"},
          std::vector<std::string>{"open_border"},
          std::vector<std::string>{"unscaled_normals", "in_line", "types_off_box"}}) {
        spec.fixes = fixes;
        checkReproduced(spec);
        checkReproduced(spec, "all-digits.obj");
    }
}

TEST_CASE("The copied command writes the same bytes: the box around the remaining points") {
    const SceneFile stray("sheet", [](PointFile& file) {
        file.position.emplace_back(40.0, 0.0, 0.0);
        file.normal.emplace_back(0.0, 0.0, 1.0);
        file.attributes[0].values.push_back(0.0);
        if (file.hasTypes()) file.type.push_back(0);
    });
    RunSpec spec = stray.spec();
    spec.walls.from = WallChoice::From::Around;
    spec.fixes = {"isolated_points"};
    checkReproduced(spec);
}

#endif

TEST_CASE("A given start is written first, beside the mesh") {
    RunSpec spec = specOf("/in/a.ply");
    spec.start.triangles = {{0, 2, 3}};
    spec.start.rings = {{0, 2, 3}};
    const MeshCommand command = meshCommand(spec, {"/out/m.ply", false});
    CHECK(command.text ==
          "printf '%s\\n' '{\"triangles\": [[0, 2, 3]], \"rings\": [[0, 2, 3]]}' > "
          "/out/a.start.json && "
          "spiraling-edge run /in/a.ply --start /out/a.start.json -o /out/m.ply");
    CHECK(command.note == "First the start is written to /out/a.start.json.");
}

TEST_CASE("The command for a pivot to practice is the one that opens it") {
    const MeshCommand command = meshCommand(specOf("practice:7"), {"m.ply", false});
    CHECK(command.text == "spiraling-edge-viewer practice:7");
    CHECK(command.note.find("practice") != std::string::npos);
}
