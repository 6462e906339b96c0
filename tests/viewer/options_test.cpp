#include "options.h"
#include "open_session.h"

#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <vector>

using namespace se;
using namespace se::view;

namespace {

ParsedOptions parse(std::vector<const char*> arguments) {
    arguments.insert(arguments.begin(), "spiraling-edge-viewer");
    return parseOptions(static_cast<int>(arguments.size()), arguments.data());
}

/// A session file about a scene, removed after the test.
struct KeptSession {
    std::filesystem::path path = test::ownPlace("options-test.sesession");
    KeptSession() {
        SessionFile s;
        s.input = changed(
            {"scene:torus"},
            specChange({{"rules", "printed"}, {"switches", "fill=on"}, {"neighbors", "16"}}));
        s.place.address = "12.sort.2";
        s.layout = LayoutPreset::Present;
        REQUIRE(writeSessionFile(path, s).ok());
    }
    ~KeptSession() { std::filesystem::remove(path); }
};

}  // namespace

TEST_CASE("A file that is read is replaced only by force, whatever it is called") {
    namespace fs = std::filesystem;
    const test::OwnFolder own;
    const fs::path& folder = own.path();
    fs::create_directories(folder / "frames");
    for (const char* name : {"p.ply", "s.json", "m.ply", "image.png", "t.lesson.md"})
        std::ofstream(folder / name) << "bytes";
    fs::create_hard_link(folder / "p.ply", folder / "p.png");
    fs::create_symlink("m.ply", folder / "m.png");
    fs::create_symlink("../image.png", folder / "frames/002.png");
    Options o;
    o.input.source = (folder / "p.ply").string();
    o.startFile = (folder / "s.json").string();
    o.with = CompareWith::otherMesh((folder / "m.ply").string());
    o.screenshot = folder / "new.png";
    CHECK(requireInputsKept(o).ok());
    for (const char* name : {"p.png", "m.png", "frames/../p.ply"}) {
        o.screenshot = folder / name;
        CAPTURE(name);
        o.force = false;
        const Status kept = requireInputsKept(o);
        REQUIRE_FALSE(kept.ok());
        CHECK(kept.error().message.find(o.screenshot.string()) != std::string::npos);
        CHECK(kept.error().message.find("--force") != std::string::npos);
        o.force = true;
        CHECK(requireInputsKept(o).ok());
    }
    o.force = false;
    o.screenshot.clear();
    o.resultFile = folder / "s.json";
    CHECK_FALSE(requireInputsKept(o).ok());
    o.screenshot = o.resultFile = folder / "both";
    CHECK_FALSE(requireInputsKept(o).ok());
    o.force = true;
    CHECK_FALSE(requireInputsKept(o).ok());
    // The frames of a lesson, and its images.
    Options exported;
    OpenedLesson lesson;
    lesson.folder = folder;
    lesson.lesson.text = "![A picture](image.png)";
    exported.exported = ExportOrder{};
    exported.exported->path = folder / "frames";
    exported.exported->lesson = std::make_shared<const OpenedLesson>(lesson);
    CHECK_FALSE(requireInputsKept(exported).ok());
    exported.exported->path = folder / "image.png";  // Writes image-001.png and so on.
    CHECK(requireInputsKept(exported).ok());
    fs::create_hard_link(folder / "image.png", folder / "page.html");
    exported.exported->path = folder / "page.html";
    CHECK_FALSE(requireInputsKept(exported).ok());
    fs::remove(folder / "frames/002.png");
    exported.exported->path = folder / "frames";
    CHECK(requireInputsKept(exported).ok());
}

TEST_CASE("Without a file there is a start page, and nothing to go to") {
    const ParsedOptions none = parse({});
    REQUIRE(none.options.has_value());
    CHECK(none.options->input.source.empty());
    CHECK(parse({"--goto", "12"}).exitCode == kExitUsage);
    CHECK_FALSE(parse({"--goto", "12"}).options.has_value());
}

TEST_CASE("Rules, layout and place are read, invalid ones are wrong usage") {
    const ParsedOptions parsed =
        parse({"scene:torus", "--rules", "printed", "--rule", "fill=on", "--rule", "closetwo=off",
               "--layout", "present", "--place",
               R"({"address": "12.sort.2", "camera": {"target": [0, 0, 0], "distance": 2,
                  "yaw": 1, "pitch": 2, "orthographic": false}})"});
    REQUIRE(parsed.options.has_value());
    const Options& o = *parsed.options;
    CHECK(o.input.rules == "printed");
    REQUIRE(o.input.choices.size() == 2);
    CHECK(o.input.choices[1] == RuleValue{"closetwo", false});
    CHECK(o.layout == LayoutPreset::Present);
    CHECK(o.goTo == "12.sort.2");
    REQUIRE(o.camera.has_value());
    CHECK(o.camera->distance == 2.0F);
    for (const std::vector<const char*>& bad :
         std::vector<std::vector<const char*>>{{"scene:torus", "--rule", "nosuch=on"},
                                               {"scene:torus", "--rule", "fill"},
                                               {"scene:torus", "--layout", "wide"},
                                               {"scene:torus", "--place", "nowhere"}}) {
        CAPTURE(bad.back());
        CHECK(parse(bad).exitCode == kExitUsage);
    }
}

TEST_CASE("--with has the options of another run, or names a mesh or a trace") {
    const auto chosen = [](std::vector<const char*> words) {
        ParsedOptions parsed = parse(words);
        REQUIRE(parsed.options.has_value());
        REQUIRE(chooseComparison(*parsed.options).ok());
        return *parsed.options;
    };
    const Options run = chosen({"scene:torus", "-k", "16", "--rule", "flip=on", "--with",
                                "--rules robust -r 0.3 --rule rim=off", "--goto", "difference"});
    REQUIRE(run.with.has_value());
    CHECK(run.atDifference);
    CHECK(run.goTo.empty());
    CHECK(run.with->kind == CompareWith::Kind::Run);
    CHECK(run.with->run.source == "scene:torus");
    CHECK(run.with->run.rules == "robust");
    // A set of rules replaces single rules.
    CHECK(run.with->run.choices == std::vector<RuleValue>{{"rim", 0.0}});
    CHECK(std::get<WithinRadius>(run.with->run.neighbors.reach).radius == 0.3);
    const Options reach = chosen({"scene:torus", "--with", "--reach 2.5"});
    CHECK(std::get<WithinSpacings>(reach.with->run.neighbors.reach).spacings == 2.5);
    CHECK(reach.with->run.neighbors.recompute);
    const Options same = chosen({"scene:torus", "-k", "16", "--with", "--rule flip=on"});
    CHECK(std::get<KNearest>(same.with->run.neighbors.reach).k == 16);
    CHECK(same.with->run.rules == "paper");
    const Options mesh = chosen({"scene:torus", "--with", "other.ply"});
    CHECK(mesh.with->kind == CompareWith::Kind::Mesh);
    CHECK(mesh.with->path == "other.ply");
    CHECK_FALSE(mesh.layout.has_value());
    // A second name is what --with names, side by side.
    const Options two = chosen({"scene:torus", "other.ply"});
    CHECK(two.with->kind == CompareWith::Kind::Mesh);
    CHECK(two.with->path == "other.ply");
    CHECK(two.layout == LayoutPreset::Compare);
    CHECK(chosen({"scene:torus", "other.ply", "--layout", "debug"}).layout == LayoutPreset::Debug);
    CHECK(parse({"scene:torus", "other.ply", "--with", "--rules robust"}).exitCode == kExitUsage);
    const Options trace = chosen({"scene:torus", "--with", "mine.setrace"});
    CHECK(trace.with->kind == CompareWith::Kind::Trace);
    CHECK(trace.layout == LayoutPreset::Compare);
    ParsedOptions alone = parse({"mine.setrace"});
    REQUIRE(alone.options.has_value());
    CHECK(adoptSession(*alone.options).ok());
    CHECK(chooseComparison(*alone.options).ok());
    CHECK(alone.options->input.source.empty());
    CHECK(alone.options->with->kind == CompareWith::Kind::Trace);
    ParsedOptions picture = parse({"mine.setrace", "--screenshot", "mine.png"});
    REQUIRE(picture.options.has_value());
    CHECK_FALSE(adoptSession(*picture.options).ok());
    CHECK(parse({"scene:torus", "--with", "--rules dragons"}).exitCode == kExitUsage);
    CHECK(parse({"scene:torus", "--with", "--goto 3"}).exitCode == kExitUsage);
}

TEST_CASE("Requested neighbors are computed, regardless of lists in the file") {
    const ParsedOptions parsed = parse({"scene:torus", "--neighbors", "16"});
    REQUIRE(parsed.options.has_value());
    CHECK(parsed.options->input.neighbors.recompute);
    CHECK(parsed.options->input.neighbors.threads == 0);
}

TEST_CASE("Derived data is requested by the names of the command line, and checked") {
    const ParsedOptions parsed = parse({"a.ply", "-k", "9", "--symmetric", "--derive-normals",
                                        "--box", "0,0,0,1,2,3", "--derive-rim", "--keep-noise"});
    REQUIRE(parsed.options.has_value());
    const RunSpec& input = parsed.options->input;
    CHECK(std::get<KNearest>(input.neighbors.reach).k == 9);
    CHECK(input.neighbors.symmetric);
    CHECK(input.normals == NormalSource::Derived);
    CHECK(input.walls.from == WallChoice::From::Box);
    CHECK(input.walls.box.high.z == 3.0);
    CHECK(valueOf(input, *findRuleSetting("noise")) == 0.0);
    CHECK(input.rim);
    CHECK(parse({"a.ply", "--box", "auto"}).options->input.walls.from == WallChoice::From::Around);
    CHECK(parse({"a.ply", "--orient"}).options->input.normals == NormalSource::Oriented);
    for (const std::vector<const char*>& bad :
         std::vector<std::vector<const char*>>{{"a.ply", "--orient", "--derive-normals"},
                                               {"a.ply", "--box", "0,0,0,1,1"},
                                               {"a.ply", "--box", "0,0,0,1,1,-1"}}) {
        CHECK(parse(bad).exitCode == kExitUsage);
    }
}

TEST_CASE("New points are requested by the names of the command line, and checked") {
    const ParsedOptions parsed = parse({"--new", "torus", "-n", "4000", "--seed", "2", "--iso=-0.5",
                                        "--box=-1,-1,-1,1,1,1", "--steps", "7"});
    REQUIRE(parsed.options.has_value());
    REQUIRE(parsed.options->grow.has_value());
    CHECK(sampleSource(*parsed.options->grow) ==
          "sample:torus,n=4000,iso=-0.5,seed=2,box=-1:-1:-1:1:1:1,steps=7");
    // That box clips the surface; it does not make walls of points on its faces.
    CHECK(parsed.options->input.walls.from == WallChoice::From::File);
    CHECK(parse({"--new", "torus"}).options->grow->count == kUsualPoints);
    CHECK(parse({"--new", "torus", "--spacing", "0.1"}).options->grow->count == 0);
    CHECK_FALSE(parse({"scene:torus"}).options->grow.has_value());
    // A volume has no points yet.
    const ParsedOptions volume = parse({"scan.nhdr"});
    CHECK(volume.options->input.source.empty());
    CHECK(volume.options->grow->surface == "scan.nhdr");
    for (const std::vector<const char*>& bad :
         std::vector<std::vector<const char*>>{{"--new", "torus", "-n", "10", "--spacing", "1"},
                                               {"--new", "torus", "--box", "auto"},
                                               {"--new", "torus", "--steps", "100000"},
                                               {"scene:torus", "--new", "torus"},
                                               {"scene:torus", "-n", "10"}}) {
        CHECK(parse(bad).exitCode == kExitUsage);
    }
}

TEST_CASE("The command line comes before the session, the session before the defaults") {
    const KeptSession kept;
    Options plain = *parse({kept.path.c_str()}).options;
    REQUIRE(adoptSession(plain).ok());
    REQUIRE(plain.session.has_value());
    CHECK(plain.input.source == "scene:torus");
    CHECK(plain.input.rules == "printed");
    CHECK(plain.input.choices == std::vector<RuleValue>{{"fill", true}});
    CHECK(std::get<KNearest>(plain.input.neighbors.reach).k == 16);
    Options given =
        *parse({kept.path.c_str(), "--rules", "paper", "--rule", "gap=on", "--neighbors", "9"})
             .options;
    REQUIRE(adoptSession(given).ok());
    CHECK(given.input.rules == "paper");
    CHECK(given.input.choices == std::vector<RuleValue>{{"gap", true}});
    CHECK(std::get<KNearest>(given.input.neighbors.reach).k == 9);
}

TEST_CASE("A session that cannot be read is an error, other files are left unchanged") {
    Options missing = *parse({"/nowhere/a.sesession"}).options;
    CHECK_FALSE(adoptSession(missing).ok());
    Options points = *parse({"/nowhere/a.ply"}).options;
    CHECK(adoptSession(points).ok());
    CHECK(points.input.source == "/nowhere/a.ply");
    CHECK_FALSE(points.session.has_value());
}

TEST_CASE("A picture that could not be written is refused before any work") {
    for (const char* path : {"no-such-folder/x.png", "/", ""}) {
        CAPTURE(path);
        CHECK(parse({"scene:sphere", "--screenshot", path}).exitCode == kExitUsage);
    }
    CHECK(parse({"scene:sphere", "--screenshot", "x.png"}).options.has_value());
}

TEST_CASE("A clean picture is the view alone, without labels, as smooth as requested") {
    const Options clean = *parse({"scene:sphere", "--screenshot", "x.png", "--background", "none",
                                  "--labels", "off", "--supersample", "3"})
                               .options;
    CHECK(clean.picture.viewAlone);
    CHECK(clean.picture.cutOut);
    CHECK_FALSE(clean.picture.labels);
    CHECK(clean.picture.supersample == 3);
    CHECK(parse({"scene:sphere", "--background", "none"}).exitCode == kExitUsage);
    CHECK(parse({"scene:sphere", "--screenshot", "x.png", "--background", "red"}).exitCode ==
          kExitUsage);
    CHECK(parse({"scene:sphere", "--screenshot", "x.png", "--size", "17000x900", "--supersample",
                 "2"})
              .exitCode == kExitUsage);
}

TEST_CASE("A picture under the name of another format is refused") {
    for (const char* name : {"x.svg", "x.gif", "x.jpg", "x"}) {
        CAPTURE(name);
        CHECK(parse({"scene:sphere", "--screenshot", name}).exitCode == kExitUsage);
    }
    CHECK(parse({"scene:sphere", "--screenshot", "x.PNG"}).options.has_value());
}

TEST_CASE("A start is read from its file, and refused with the entry that is wrong") {
    const std::filesystem::path file = test::ownPlace("start.json");
    std::ofstream(file) << R"({"triangles": [[0, 2, 3]], "rings": [[0, 2, 3]]})";
    const std::string path = file.string();
    ParsedOptions parsed = parse({"points.ply", "--start", path.c_str()});
    REQUIRE(parsed.options.has_value());
    REQUIRE(adoptStart(*parsed.options).ok());
    CHECK(parsed.options->input.start.triangles == std::vector<Triangle>{{0, 2, 3}});
    std::ofstream(file) << R"({"rings": [[0, "two"]]})";
    const Status refused = adoptStart(*parsed.options);
    REQUIRE_FALSE(refused.ok());
    CHECK(refused.error().message.find(path + ": rings[0][1]: expected") == 0);
    std::filesystem::remove(file);
    CHECK(parse({"lesson:tour", "--start", path.c_str()}).exitCode == kExitUsage);
}

TEST_CASE("A link in place of FILE opens its place, and options beside it win") {
    const ParsedOptions plain =
        parse({"https://example.org/spiraling-edge/#scene=torus&goto=137.sphere.3&rules=robust"});
    REQUIRE(plain.options.has_value());
    CHECK(plain.options->goTo == "137.sphere.3");
    CHECK(plain.options->input == changed({"scene:torus"}, specChange({{"rules", "robust"}})));
    const ParsedOptions other =
        parse({"#scene=torus&goto=137.sphere.3&rules=robust&theme=light&layout=present", "--goto",
               "5", "--rules", "paper", "--theme", "dark"});
    REQUIRE(other.options.has_value());
    CHECK(other.options->goTo == "5");
    CHECK(other.options->input == RunSpec{"scene:torus"});
    CHECK(other.options->theme == Theme::Dark);
    CHECK(other.options->layout == LayoutPreset::Present);
    ParsedOptions lesson = parse({"#lesson=tour&step=2"});
    REQUIRE(lesson.options.has_value());
    REQUIRE(adoptLesson(*lesson.options).ok());
    CHECK(lesson.options->lesson == "lesson:tour");
    CHECK(lesson.options->lessonStep == 1U);
}

TEST_CASE("A wrong link is wrong usage") {
    for (const char* link : {"#scene=toros", "x.html#scene=torus&gto=1", "#pack=a.xyz:!",
                             "#nothing", "#goto=5", "#scene=torus&rules=strict"}) {
        CAPTURE(link);
        const ParsedOptions parsed = parse({link});
        CHECK_FALSE(parsed.options.has_value());
        CHECK(parsed.exitCode == kExitUsage);
    }
}
