#include "session/session_file.h"

#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>

#include "open_session.h"
#include "run/model.h"
#include "teach/file_bytes.h"

using namespace se;
using namespace se::view;
namespace fs = std::filesystem;

namespace {

void put(const fs::path& path, std::string_view text) {
    std::ofstream file(path, std::ios::binary);
    file << text;
}

SessionFile fullSession() {
    SessionFile s;
    s.input.source = "/data/scans/kitten.xyz";
    s.input.rules = "robust";
    s.input.choices = {{"closetwo", false}, {"fill", true}, {"maxgap", 100.5}, {"tie", 1.0}};
    s.input.whatIf = {whatIfFromText("137.sphere keep 812").value(),
                      whatIfFromText("9 move 4 0.1 0.2 1e-07").value()};
    s.input.neighbors = {KNearest{16}, true, 0, true};
    s.inputHash = "fnv1a64:0123456789abcdef";
    s.place.address = "137.sphere.3";
    s.place.camera = CameraPose{{0.1F, 0.2F, 0.3F}, 2.5F, 30.0F, -10.0F, true};
    s.layers = LayerModes{};
    modeOf(*s.layers, LayerId::Labels) = LayerMode::PinnedOff;
    modeOf(*s.layers, LayerId::Normals) = LayerMode::PinnedOn;
    s.layout = LayoutPreset::Present;
    s.selected = Selection::ofPoint(812);
    insertBookmark(s.annotations.bookmarks,
                   {*addressFromString("12.sort.2"), "the first \"odd\" one"});
    insertBookmark(s.annotations.bookmarks, {*addressFromString("40.sphere.1"), ""});
    s.annotations.breakpoints = {{"far out", "stage=sphere refused", 3, 7, false, false},
                                 {"", "stage=dragon", 0, 1, true, true}};
    s.annotations.watches = {"ring", "status=812"};
    s.annotations.notes = "Two lines,\nwith \xC3\xA4 sign.";
    s.query = "stage=sphere kept margin<1e-4";
    return s;
}

std::string minimal(const std::string& more) {
    return R"({"format": "spiraling-edge session", "version": 1, "input": {"source": "scene:torus"})" +
           more + "}";
}

std::string complaintOf(const std::string& text) {
    const auto read = sessionFromJson(text, "a.sesession", "");
    return read.ok() ? "" : read.error().message;
}

}  // namespace

TEST_CASE("A session file is read back as written, the path relative to the file") {
    const SessionFile s = fullSession();
    const std::string text = sessionToJson(s, "/data/sessions");
    CHECK(text.find("\"../scans/kitten.xyz\"") != std::string::npos);
    const auto read = sessionFromJson(text, "a.sesession", "/data/sessions");
    REQUIRE(read.ok());
    const SessionFile& r = read.value();
    CHECK(r.input.source == s.input.source);
    CHECK(r.input.rules == s.input.rules);
    CHECK(r.input.choices == s.input.choices);
    CHECK(r.input.whatIf == s.input.whatIf);
    CHECK(r.input.neighbors.recompute);
    CHECK(std::get<KNearest>(r.input.neighbors.reach).k == 16);
    CHECK(r.inputHash == s.inputHash);
    CHECK(r.place.address == s.place.address);
    CHECK(r.place.camera == s.place.camera);
    CHECK(r.annotations.breakpoints == s.annotations.breakpoints);
    CHECK(r.annotations.watches == s.annotations.watches);
    CHECK(r.layers == s.layers);
    CHECK(r.layout == s.layout);
    CHECK(r.selected == s.selected);
    CHECK(r.annotations.bookmarks == s.annotations.bookmarks);
    CHECK(r.annotations.notes == s.annotations.notes);
    CHECK(r.query == s.query);
    CHECK(sessionToJson(r, "/data/sessions") == text);
}

TEST_CASE(
    "What is derived, and points that are grown, come back, the path of a volume moves along") {
    SessionFile session;
    session.input.source = "sample:/data/scans/lobster.nhdr,n=900,iso=40";
    session.input.neighbors = {KNearest{9}, true, 0, true, true};
    session.input.normals = NormalSource::Oriented;
    session.input.walls = {WallChoice::From::Box, {{0, 0, 0}, {1, 2.5, 3}}};
    session.input.rim = true;
    const std::string text = sessionToJson(session, "/data/work");
    CHECK(text.find("sample:../scans/lobster.nhdr,n=900,iso=40") != std::string::npos);
    const Result<SessionFile> read = sessionFromJson(text, "a.sesession", "/other/work");
    REQUIRE(read.ok());
    const RunSpec& back = read.value().input;
    CHECK(back.source == "sample:/other/scans/lobster.nhdr,n=900,iso=40");
    CHECK(back.neighbors.symmetric);
    CHECK(back.normals == NormalSource::Oriented);
    CHECK(back.walls == session.input.walls);
    CHECK(back.rim);
    session.input = RunSpec{"scene:sphere"};
    session.original = text;
    const std::string usual = sessionToJson(session, "/data/work");
    for (const char* name : {"\"normals\"", "\"box\"", "symmetric", "\"rim\""}) {
        CAPTURE(name);
        CHECK(text.find(name) != std::string::npos);
        CHECK(usual.find(name) == std::string::npos);
    }
}

TEST_CASE("A session and its input can be moved together") {
    const std::string text = sessionToJson(fullSession(), "/data/sessions");
    const auto read = sessionFromJson(text, "a.sesession", "/mnt/stick/sessions");
    REQUIRE(read.ok());
    CHECK(read.value().input.source == "/mnt/stick/scans/kitten.xyz");
}

TEST_CASE("Unknown fields are kept, at any position") {
    const std::string text = minimal(
        R"(, "future": [1, 2], "layers": {"points": "on", "hologram": "on"},
            "options": {"rules": "paper", "speed": 3})");
    const auto read = sessionFromJson(text, "a.sesession", "");
    REQUIRE(read.ok());
    SessionFile changed = read.value();
    changed.annotations.notes = "new";
    const std::string written = sessionToJson(changed, "");
    for (const char* kept : {"\"future\"", "\"hologram\": \"on\"", "\"speed\": 3", "\"new\""}) {
        CAPTURE(kept);
        CHECK(written.find(kept) != std::string::npos);
    }
}

TEST_CASE("Unknown layers and modes are skipped and reported, the others are used") {
    const auto read = sessionFromJson(
        minimal(R"(, "layers": {"points": 1, "hologram": "on", "normals": "on", "links": "no"})"),
        "folder/a.sesession", "");
    REQUIRE(read.ok());
    LayerModes expected{};
    modeOf(expected, LayerId::Normals) = LayerMode::PinnedOn;
    CHECK(read.value().layers == expected);
    const std::string& sentence = read.value().leftOut;
    CHECK(sentence.starts_with("a.sesession: "));
    for (const char* named : {"\"hologram\"", "mode 1 of layer \"points\"", "mode \"no\""}) {
        CAPTURE(named);
        CHECK(sentence.find(named) != std::string::npos);
    }
    CHECK(sessionFromJson(minimal(R"(, "layers": {"points": "on"})"), "a", "").value().leftOut ==
          "");
}

TEST_CASE("Missing fields are left open: three fields are enough") {
    const auto read = sessionFromJson(minimal(""), "a.sesession", "");
    REQUIRE(read.ok());
    CHECK(read.value().input.source == "scene:torus");
    CHECK(read.value().input.rules == "paper");
    CHECK_FALSE(read.value().input.neighbors.recompute);
    CHECK_FALSE(read.value().layers.has_value());
    CHECK_FALSE(read.value().layout.has_value());
    CHECK(read.value().selected == Selection{});
    CHECK(read.value().annotations.bookmarks.empty());
}

TEST_CASE("A bad session file is refused with its name and what was expected") {
    struct Bad {
        std::string text;
        const char* says;
    };
    const Bad all[] = {
        {"", "line 1, column 1: expected JSON"},
        {"{\n", "line 2, column 1: expected JSON"},
        {"[]", "JSON object"},
        {R"({"version": 1})", "\"format\""},
        {R"({"format": "spiraling-edge session"})", "\"version\""},
        {R"({"format": "spiraling-edge session", "version": 2})", "at most 1"},
        {R"({"format": "spiraling-edge session", "version": 1, "input": 3})", "\"input\""},
        {minimal(R"(, "options": [])"), "\"options\""},
        {minimal(R"(, "options": {"rules": "best"})"), "options.rules"},
        {minimal(R"(, "options": {"switches": {"nosuch": true}})"), "nosuch"},
        {minimal(R"(, "options": {"switches": {"fill": "yes"}})"), "options.switches.fill"},
        {minimal(R"(, "options": {"switches": {"maxgap": 300}})"), "a number from 90 to 180"},
        {minimal(R"(, "options": {"switches": {"tie": true}})"),
         "tie=nearest, tie=farthest or tie=both"},
        {minimal(R"(, "options": {"what_if": "5.sphere keep 3"})"), "a list of texts"},
        {minimal(R"(, "options": {"what_if": ["5.sphere hold 3"]})"), "is no what-if"},
        {minimal(R"(, "options": {"neighbors": 0})"), "1 to 1000"},
        {minimal(R"(, "options": {"neighbors": 2.5})"), "1 to 1000"},
        {minimal(R"(, "options": {"radius": -1})"), "a number > 0"},
        {minimal(R"(, "options": {"normals": "up"})"), "options.normals"},
        {minimal(R"(, "options": {"box": [0, 0, 0, 1, 1]})"), "options.box"},
        {minimal(R"(, "options": {"box": [0, 0, 0, 1, 1, 0]})"), "options.box"},
        {minimal(R"(, "options": {"symmetric": 1})"), "options.symmetric"},
        {minimal(R"(, "address": "137.nowhere.3")"), "\"address\""},
        {minimal(R"(, "address": 137)"), "\"address\""},
        {minimal(R"(, "camera": {"distance": 1})"), "\"camera\""},
        {minimal(R"(, "layout": "wide")"), "\"layout\""},
        {minimal(R"(, "selected": -4)"), "\"selected\""},
        {minimal(R"(, "selected": [])"), "\"selected\""},
        {minimal(R"(, "selected": [3, 3])"), "\"selected\""},
        {minimal(R"(, "selected": [1, 2, 3, 4])"), "\"selected\""},
        {minimal(R"(, "bookmarks": {})"), "\"bookmarks\""},
        {minimal(R"(, "bookmarks": [{"note": "x"}])"), "\"bookmarks\""},
        {minimal(R"(, "notes": 1)"), "\"notes\""},
        {minimal(R"(, "query": 1)"), "\"query\""},
        {minimal(R"(, "breakpoints": {})"), "\"breakpoints\""},
        {minimal(R"(, "breakpoints": [{"name": "x"}])"), "\"breakpoints\""},
        {minimal(R"(, "breakpoints": [{"line": "closes", "every": 0}])"), "\"breakpoints\""},
        {minimal(R"(, "breakpoints": [{"line": "closes", "skip": -1}])"), "\"breakpoints\""},
        {minimal(R"(, "watches": "ring")"), "\"watches\""},
        {minimal(R"(, "watches": [1])"), "\"watches\""},
        // Numbers that are out of range.
        {R"({"format": "spiraling-edge session", "version": 99999999999999999999})", "\"version\""},
        {R"({"format": "spiraling-edge session", "version": -1})", "\"version\""},
        {minimal(R"(, "options": {"neighbors": 1e300})"), "options.neighbors"},
        {minimal(R"(, "options": {"neighbors": 99999999999999999999})"), "options.neighbors"},
        {minimal(R"(, "options": {"neighbors": -1})"), "options.neighbors"},
        {minimal(R"(, "options": {"reach": 1e999})"), "\"options.reach\""},
        {minimal(R"(, "options": {"radius": -1e999})"), "\"options.radius\""},
        {minimal(R"(, "options": {"box": [0, 0, 0, 1, 1, 1e999]})"), "\"options.box\""},
        {minimal(R"(, "options": {"switches": {"maxgap": 1e300}})"), "options.switches.maxgap"},
        {minimal(R"(, "options": {"what_if": ["5.sphere keep 99999999999"]})"), "is no what-if"},
        {minimal(R"(, "address": "99999999999.sphere.1")"), "\"address\""},
        {minimal(R"(, "address": "1.sphere.99999999999")"), "\"address\""},
        {minimal(R"(, "camera": {"target": [0, 0, 0], "distance": 1e300, "yaw": 0, "pitch": 0})"),
         "\"camera\""},
        {minimal(R"(, "camera": {"target": [0, 0, 1e999], "distance": 1, "yaw": 0, "pitch": 0})"),
         "\"camera.target\""},
        {minimal(R"(, "selected": 4294967295)"), "\"selected\""},
        {minimal(R"(, "selected": 1e300)"), "\"selected\""},
        {minimal(R"(, "selected": [1, 99999999999999999999])"), "\"selected\""},
        {minimal(R"(, "bookmarks": [{"address": "99999999999"}])"), "\"bookmarks\""},
        {minimal(R"(, "breakpoints": [{"line": "closes", "skip": 4294967296}])"),
         "\"breakpoints\""},
        {minimal(R"(, "deep": )" + std::string(100, '[') + std::string(100, ']')), "64 levels"},
    };
    for (const Bad& bad : all) {
        CAPTURE(bad.text);
        const std::string complaint = complaintOf(bad.text);
        CHECK(complaint.starts_with("a.sesession: "));
        CHECK(complaint.find(bad.says) != std::string::npos);
    }
}

TEST_CASE(
    "Session files are distinguished from point files by extension or by their first character") {
    const test::OwnFolder folder;
    put(folder / "a.json", "  \n{\"format\": 1}");
    put(folder / "a.xyz", "0 0 0 0 0 1\n");
    CHECK(looksLikeSession(folder / "missing.sesession"));
    CHECK(looksLikeSession("A.SESESSION"));
    CHECK(looksLikeSession(folder / "a.json"));
    CHECK_FALSE(looksLikeSession(folder / "a.xyz"));
    CHECK_FALSE(looksLikeSession(folder / "missing.ply"));
    CHECK_FALSE(looksLikeSession(folder.path()));
}

TEST_CASE("Session files are written whole, and an unreadable one is an error with its path") {
    const test::OwnFolder folder;
    const fs::path path = folder / "kitten.sesession";
    REQUIRE(writeSessionFile(path, fullSession()).ok());
    const auto read = readSessionFile(path);
    REQUIRE(read.ok());
    CHECK(read.value().annotations.notes == fullSession().annotations.notes);
    CHECK(std::distance(fs::directory_iterator(folder.path()), fs::directory_iterator()) == 1);
    const auto missing = readSessionFile(folder / "missing.sesession");
    REQUIRE_FALSE(missing.ok());
    CHECK(missing.error().message.find("missing.sesession") != std::string::npos);
    CHECK_FALSE(writeSessionFile(folder / "no" / "folder.sesession", fullSession()).ok());
}

TEST_CASE("The hash of an input is FNV-1a of its bytes") {
    teach::ByteHash hash;
    CHECK(hash.text() == "fnv1a64:cbf29ce484222325");
    hash.add("a");
    CHECK(hash.text() == "fnv1a64:af63dc4c8601ec8c");
    teach::ByteHash inPieces;
    for (const char* piece : {"foo", "", "bar"}) inPieces.add(piece);
    CHECK(inPieces.text() == "fnv1a64:85944171f73967e8");
}

TEST_CASE("Rule choices are read from NAME=on and NAME=off, and nothing else") {
    REQUIRE(ruleValueFromText("fill=on").ok());
    CHECK(ruleValueFromText("closetwo=off").value() == RuleValue{"closetwo", false});
    for (const char* bad : {"", "fill", "fill=", "fill=yes", "nosuch=on", "=on"}) {
        CAPTURE(bad);
        CHECK_FALSE(ruleValueFromText(bad).ok());
    }
    Params params;
    const std::vector<RuleValue> values{{"fill", true}, {"closetwo", false}};
    REQUIRE(applyRuleValues(values, params).ok());
    CHECK(params.robust.fill);
    CHECK_FALSE(params.readings.closeTwo);
}

TEST_CASE("The comparison is kept: another run by its options, a mesh by its path") {
    const test::OwnFolder folder;
    SessionFile s = fullSession();
    s.with = CompareWith::otherRun(s.input);
    s.with.run.rules = "paper";
    s.with.run.choices = {{"flip", true}};
    s.with.run.neighbors = {WithinRadius{0.25}, true, 0, true};
    const auto run = sessionFromJson(sessionToJson(s, folder.path()), "a.sesession", folder.path());
    REQUIRE(run.ok());
    CHECK(run.value().with.kind == CompareWith::Kind::Run);
    CHECK(run.value().with.run.rules == "paper");
    CHECK(run.value().with.run.choices == s.with.run.choices);
    CHECK(std::get<WithinRadius>(run.value().with.run.neighbors.reach).radius == 0.25);
    s.with = CompareWith::otherMesh((folder / "meshes" / "other.ply").string());
    const std::string text = sessionToJson(s, folder.path());
    CHECK(text.find("\"mesh\": \"meshes/other.ply\"") != std::string::npos);
    const auto mesh = sessionFromJson(text, "a.sesession", folder.path());
    REQUIRE(mesh.ok());
    CHECK(mesh.value().with.path == s.with.path);
    CHECK(complaintOf(minimal(R"(, "compare": 3)")).find("compare") != std::string::npos);
    CHECK(complaintOf(minimal(R"(, "compare": {"options": {"rules": "x"}})")).find("rules") !=
          std::string::npos);
}

TEST_CASE("A session names regular files: no device, no pipe, no folder") {
    const test::OwnFolder folder;
    put(folder / "points.xyz", "0 0 0\n");
    fs::create_directories(folder / "folder");
    const auto named = [&](const std::string& source, const std::string& more) {
        put(folder / "a.sesession",
            R"({"format": "spiraling-edge session", "version": 1, "input": {"source": ")" + source +
                "\"}" + more + "}");
        const auto read = readSessionFile(folder / "a.sesession");
        return read ? std::string() : read.error().message;
    };
    CHECK(named("points.xyz", "").empty());
    // A missing file is reported when it is opened.
    CHECK(named("missing.xyz", "").empty());
    for (const char* source : {"/dev/zero", "folder", "sample:/dev/../dev/zero.nrrd,n=5"}) {
        CAPTURE(source);
        const bool there = fs::exists(source) || std::string(source) == "folder";
        CHECK(named(source, "").empty() == !there);
    }
    CHECK(named("/dev/zero", "").find("\"input.source\"") != std::string::npos);
    CHECK(named("/dev/zero", "").find("/dev/zero") != std::string::npos);
    fs::create_symlink("/dev/zero", folder / "zero.nrrd");
    CHECK(named("sample:zero.nrrd,n=5", "").find("\"input.source\"") != std::string::npos);
    CHECK(named("points.xyz", R"(, "compare": {"mesh": "/dev/zero"})").find("\"compare.mesh\"") !=
          std::string::npos);
    fs::create_symlink("/dev/zero", folder / "zero.sesession");
    const auto device = readSessionFile(folder / "zero.sesession");
    REQUIRE_FALSE(device.ok());
    CHECK(device.error().message.find("regular file") != std::string::npos);
}

TEST_CASE("A given start is kept, and refused with its entry") {
    const test::OwnFolder folder;
    SessionFile s = fullSession();
    s.input.start = {{{0, 2, 3}}, {{0, 2, 3}}, {7}, {{3, 0}}};
    const auto read =
        sessionFromJson(sessionToJson(s, folder.path()), "a.sesession", folder.path());
    REQUIRE(read.ok());
    CHECK(read.value().input.start == s.input.start);
    s.original = sessionToJson(s, folder.path());
    s.input.start = {};
    CHECK(sessionToJson(s, folder.path()).find("\"start\"") == std::string::npos);
    CHECK(complaintOf(minimal(R"(, "options": {"start": {"rings": [[0, -1]]}})"))
              .find("\"options.start\": rings[0][1]: expected the number of a point") !=
          std::string::npos);
}

TEST_CASE("A compared trace is kept by its path") {
    const test::OwnFolder folder;
    SessionFile s = fullSession();
    s.with = CompareWith::otherFile((folder / "traces" / "mine.setrace").string());
    const std::string text = sessionToJson(s, folder.path());
    CHECK(text.find("\"trace\": \"traces/mine.setrace\"") != std::string::npos);
    const auto read = sessionFromJson(text, "a.sesession", folder.path());
    REQUIRE(read.ok());
    CHECK(read.value().with.kind == CompareWith::Kind::Trace);
    CHECK(read.value().with.path == s.with.path);
}
