// Files that version 0.1.0 wrote (tests/golden/0.1.0), compared field by field with what was set.
// They are never written again.
#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "headless_app.h"
#include "panel_state/settings.h"
#include "session/session_file.h"

using namespace se;
using namespace se::view;
namespace fs = std::filesystem;

namespace {

const fs::path kFolder = fs::path(SPIRALING_EDGE_GOLDEN_DIR) / "0.1.0";

SessionFile savedSession() {
    const Result<SessionFile> read = readSessionFile(kFolder / "session.sesession");
    REQUIRE(read.ok());
    return read.value();
}

ViewSettings savedSettings() {
    const Result<ViewSettings> read = readSettings(kFolder / "settings.json");
    REQUIRE(read.ok());
    return read.value();
}

/// Lines of JSON, without the commas between fields.
std::vector<std::string> linesOf(std::istream&& text) {
    std::vector<std::string> lines;
    for (std::string line; std::getline(text, line);) {
        if (line.ends_with(',')) line.pop_back();
        lines.push_back(line);
    }
    return lines;
}

/// The first line of a file that is not, in order, in `text`; empty if all are.
std::string lostLine(const fs::path& path, const std::string& text) {
    const std::vector<std::string> now = linesOf(std::istringstream(text));
    auto from = now.begin();
    for (const std::string& line : linesOf(std::ifstream(path))) {
        // What was kept is a rule turned off today.
        if (line.find("\"keep_") != std::string::npos) continue;
        from = std::find(from, now.end(), line);
        if (from == now.end()) return line;
        ++from;
    }
    return {};
}

}  // namespace

TEST_CASE("0.1.0: a session has the input and the options that were set") {
    const SessionFile session = savedSession();
    const RunSpec& input = session.input;
    CHECK(fs::path(input.source) == kFolder.lexically_normal() / "points.xyz");
    CHECK(session.inputHash == "fnv1a64:04485b5e5d062ae0");
    CHECK(input.rules == "corrected");
    CHECK(input.choices == std::vector<RuleValue>{{"cap", 12.0},
                                                  {"closetwo", 0.0},
                                                  {"maxgap", 110.5},
                                                  {"tie", 1.0},
                                                  {"opposing", 0.0},
                                                  {"noise", 0.0}});
    CHECK(input.fixes == std::vector<std::string>{"duplicates"});
    CHECK(input.neighbors.recompute);
    REQUIRE(std::holds_alternative<WithinSpacings>(input.neighbors.reach));
    CHECK(std::get<WithinSpacings>(input.neighbors.reach).spacings == 2.1);
    CHECK(input.neighbors.symmetric);
    CHECK(input.normals == NormalSource::Derived);
    CHECK(input.walls == WallChoice{WallChoice::From::Box, {{-1, -1, -1}, {12.5, 12.5, 1}}});
    CHECK(input.rim);
    CHECK(valueOf(input, *findRuleSetting("opposing")) == 0.0);
    CHECK(valueOf(input, *findRuleSetting("noise")) == 0.0);
    std::vector<WhatIf> whatIfs;
    for (const char* line : {"30.sphere keep 60", "31 move 90 7.5 8.25 0.0625",
                             "32 list 91 90 92 79", "50.advance pivot 61"}) {
        whatIfs.push_back(whatIfFromText(line).value());
    }
    CHECK(input.whatIf == whatIfs);
}

TEST_CASE("0.1.0: a session has the place, the looks and the comparison that were set") {
    const SessionFile session = savedSession();
    CHECK(session.place.address == "31.pivot.1");
    CHECK(session.place.camera ==
          CameraPose{{-0.00014141038991510868F, -0.0032256816048175097F, -0.0016946272226050496F},
                     2.808741569519043F,
                     -166.9990997314453F,
                     27.0F,
                     true,
                     UpAxis::Z});
    LayerModes layers{};
    modeOf(layers, LayerId::Normals) = LayerMode::PinnedOn;
    modeOf(layers, LayerId::Labels) = LayerMode::PinnedOff;
    modeOf(layers, LayerId::StackedRings) = LayerMode::PinnedOff;
    CHECK(session.layers == layers);
    CHECK(session.leftOut == "");
    CHECK(session.layout == LayoutPreset::Compare);
    CHECK(session.selected == Selection::ofEdge(41, 40));
    CHECK(session.alert == "unused_points:1");
    REQUIRE(session.with.kind == CompareWith::Kind::Run);
    const RunSpec& other = session.with.run;
    CHECK(other.rules == "robust");
    CHECK(other.choices == std::vector<RuleValue>{{"flip", 0.0}});
    CHECK(other.fixes == std::vector<std::string>{"duplicates"});
    CHECK(other.normals == NormalSource::Oriented);
    REQUIRE(std::holds_alternative<KNearest>(other.neighbors.reach));
    CHECK(std::get<KNearest>(other.neighbors.reach).k == 12);
}

TEST_CASE("0.1.0: a session has the annotations that were set") {
    const SessionFile session = savedSession();
    CHECK(
        session.annotations.bookmarks ==
        Bookmarks{{{12, Stage::Sort, 2}, "the first \"odd\" one"}, {{40, Stage::Advance, 1}, ""}});
    CHECK(session.annotations.notes == "Two lines,\nwith \xC3\xA4 sign.");
    CHECK(session.query == "stage=sphere kept margin<1e-4");
    CHECK(session.annotations.breakpoints ==
          std::vector<Breakpoint>{{"far out", "stage=sphere refused", 3, 2, false, false},
                                  {"", "point=118", 0, 1, true, true}});
    CHECK(session.annotations.watches == std::vector<std::string>{"ring", "status=40"});
}

TEST_CASE("0.1.0: a session opens where it was saved, without a complaint") {
    test::HeadlessApp app("first-version-test");
    app.document.open((kFolder / "session.sesession").string());
    app.waitUntilDone();
    REQUIRE(app.session.input().phase() == SessionPhase::Ready);
    CHECK(app.session.messages().last().empty());
    CHECK(toString(app.session.address()) == "31.pivot.1");
    CHECK(app.session.selection() == Selection::ofEdge(40, 41));
    CHECK(app.session.model().points.size() == 144);  // 2 of them without a normal
    CHECK(app.ui.bookmarks.size() == 2);
    CHECK(app.document.takeAlert() == "unused_points:1");
    app.compare.poll();
    CHECK(app.compare.comparison().chosen());
}

TEST_CASE("0.1.0: a session and settings that are saved again keep every field") {
    CHECK(lostLine(kFolder / "session.sesession", sessionToJson(savedSession(), kFolder)) == "");
    CHECK(lostLine(kFolder / "settings.json", settingsToJson(savedSettings())) == "");
    CHECK(lostLine(kFolder / "state.json",
                   keptStateToJson(readKeptState(kFolder / "state.json"))) ==
          R"(  "layout": "learn")");  // That is Debug now.
}

TEST_CASE("0.1.0: settings are those that were set") {
    const ViewSettings settings = savedSettings();
    CHECK(settings.complaints.empty());
    CHECK(settings.theme == Theme::Light);
    CHECK(settings.uiScale == 1.5);
    CHECK(settings.width == 1400);
    CHECK(settings.height == 900);
    CHECK(settings.playRate == 8.0);
    CHECK_FALSE(settings.legend);
    CHECK(settings.keys.changes() == KeyMap::Changes{{"run.unit", "J"}});
    CHECK(settings.meshStyle == MeshStyle::Wire);
    CHECK(settings.pointTint == PointTint::Margin);
    CHECK(settings.up == UpAxis::Y);
    LayerModes layers{};
    modeOf(layers, LayerId::Normals) = LayerMode::PinnedOn;
    modeOf(layers, LayerId::Labels) = LayerMode::PinnedOff;
    CHECK(settings.layers == layers);
}

TEST_CASE("0.1.0: the layout and the recent inputs are those that were kept") {
    CHECK(readKeptState(kFolder / "state.json") ==
          KeptState{LayoutPreset::Debug, {"sample:torus,n=300"}});
}
