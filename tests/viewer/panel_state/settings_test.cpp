#include "panel_state/settings.h"
#include "open_session.h"
#include "run/strings.h"

#include <doctest/doctest.h>

#include <cstdlib>
#include <filesystem>

using namespace se::view;

TEST_CASE("Settings are read back as written") {
    ViewSettings settings;
    settings.theme = Theme::Light;
    settings.uiScale = 1.5;
    settings.width = 1600;
    settings.height = 900;
    settings.playRate = 15.0;
    settings.legend = false;
    settings.panels.of(Splitter::Left) = 17.5F;
    settings.panels.folded = true;
    modeOf(settings.layers, LayerId::Normals) = LayerMode::PinnedOn;
    modeOf(settings.layers, LayerId::Spheres) = LayerMode::PinnedOff;
    const auto read = settingsFromJson(settingsToJson(settings));
    REQUIRE(read.ok());
    CHECK(read.value().theme == settings.theme);
    CHECK(read.value().uiScale == settings.uiScale);
    CHECK(read.value().width == settings.width);
    CHECK(read.value().height == settings.height);
    CHECK(read.value().playRate == settings.playRate);
    CHECK(read.value().legend == settings.legend);
    CHECK(read.value().panels == settings.panels);
    CHECK(read.value().layers == settings.layers);
}

TEST_CASE("A mesh style is kept if it was chosen, the default of an earlier version is not") {
    const auto styleIn = [](std::string_view text) {
        return settingsFromJson(text).value().meshStyle;
    };
    CHECK(styleIn(R"({"meshStyle": "flat"})") == MeshStyle::Faults);
    CHECK(styleIn(R"({"meshStyle": "wire"})") == MeshStyle::Wire);
    for (const MeshStyleRow& row : meshStyles()) {
        ViewSettings settings;
        settings.meshStyle = row.id;
        CHECK(styleIn(settingsToJson(settings)) == row.id);
    }
}

TEST_CASE("Values out of range or of another type become defaults") {
    const auto read = settingsFromJson(
        R"({"theme": 7, "uiScale": 99, "width": -3, "height": "tall", "layers": {"points": 1}, "x": 1})");
    REQUIRE(read.ok());
    const ViewSettings defaults;
    CHECK(read.value().theme == defaults.theme);
    CHECK(read.value().uiScale == defaults.uiScale);
    CHECK(read.value().width == defaults.width);
    CHECK(read.value().height == defaults.height);
    CHECK(read.value().layers == defaults.layers);
}

TEST_CASE("Layers that an earlier version kept as true and false become pins where they differ") {
    const auto read = settingsFromJson(
        R"({"layers": {"normals": true, "links": false, "spheres": false, "labels": true}})");
    REQUIRE(read.ok());
    LayerModes expected{};
    modeOf(expected, LayerId::Normals) = LayerMode::PinnedOn;
    modeOf(expected, LayerId::Spheres) = LayerMode::PinnedOff;
    CHECK(read.value().layers == expected);
}

TEST_CASE("Layers of the settings are read like those of a session: unknown ones are reported") {
    const auto read =
        settingsFromJson(R"({"layers": {"points": "dim", "x": "on", "links": "off"}})");
    REQUIRE(read.ok());
    LayerModes expected{};
    modeOf(expected, LayerId::Links) = LayerMode::PinnedOff;
    CHECK(read.value().layers == expected);
    REQUIRE(read.value().complaints.size() == 1);
    CHECK(
        read.value().complaints.front() ==
        "settings.json: Ignored, since unknown in this version: mode \"dim\" of layer \"points\", "
        "layer \"x\".");
}

TEST_CASE("Text that is no JSON object is an error, not a crash") {
    for (const char* text : {"", "[]", "{", "null", "\xFF\xFE"}) {
        CAPTURE(text);
        CHECK_FALSE(settingsFromJson(text).ok());
    }
}

TEST_CASE("Files go to the XDG folders, without a file there are defaults") {
    const std::filesystem::path folder = test::ownPlace("settings-test");
    std::filesystem::remove_all(folder);
    setenv("XDG_CONFIG_HOME", folder.c_str(), 1);
    CHECK(settingsPath() == folder / "spiraling-edge" / "settings.json");
    CHECK(readSettings(settingsPath()).ok());
    ViewSettings settings;
    settings.width = 999;
    REQUIRE(writeSettings(settingsPath(), settings).ok());
    CHECK(readSettings(settingsPath()).value().width == 999);
    std::filesystem::remove_all(folder);
    setenv("XDG_CONFIG_HOME", "relative", 1);
    CHECK(settingsPath() != std::filesystem::path("relative") / "spiraling-edge" / "settings.json");
    unsetenv("XDG_CONFIG_HOME");
}

TEST_CASE("The chosen up axis is kept, without one it is guessed") {
    ViewSettings settings;
    CHECK_FALSE(settingsFromJson(settingsToJson(settings)).value().up.has_value());
    settings.up = UpAxis::X;
    CHECK(settingsFromJson(settingsToJson(settings)).value().up == UpAxis::X);
    CHECK_FALSE(settingsFromJson(R"({"up": "w"})").value().up.has_value());
}

TEST_CASE("The latest file is first and listed once, and the oldest ones are dropped") {
    KeptState state;
    for (int i = 0; i < 14; ++i) remember(state, "/data/" + std::to_string(i) + ".ply");
    remember(state, "/data/9.ply");
    remember(state, "/data/sub/../9.ply");
    REQUIRE(state.recent.size() == kMaxRecent);
    CHECK(state.recent[0] == "/data/9.ply");
    CHECK(state.recent[1] == "/data/13.ply");
    CHECK(state.recent.back() == "/data/4.ply");
}

TEST_CASE("Scenes and nothing are no recent files, relative paths become absolute") {
    KeptState state;
    remember(state, "scene:torus");
    remember(state, "");
    CHECK(state.recent.empty());
    remember(state, "here.ply");
    REQUIRE(state.recent.size() == 1);
    CHECK(std::filesystem::path(state.recent[0]).is_absolute());
}

TEST_CASE("Sampled points are recorded by their specification, with a readable name") {
    KeptState state;
    remember(state, "sample:torus,n=4000");
    remember(state, "/data/a.ply");
    remember(state, "sample:torus,n=4000");
    REQUIRE(state.recent.size() == 2);
    CHECK(state.recent[0] == "sample:torus,n=4000");
    CHECK(recentName(state.recent[0]) == "torus, " + grouped(4000) + " points");
    CHECK(recentName("/data/a.ply") == "a.ply");
    CHECK(recentName("sample:gyroid,spacing=0.25,steps=9") == "gyroid, 0.25 apart, step 9");
    // From any folder.
    remember(state, "sample:scans/lobster.nhdr,n=500");
    CHECK(state.recent[0].starts_with("sample:/"));
    CHECK(recentName(state.recent[0]) == "lobster, 500 points");
    remember(state, "sample:");
    CHECK(state.recent.size() == 3);
}

TEST_CASE("Layout and recent files are read back as written") {
    KeptState state{LayoutPreset::Present,
                    {"/a.ply", "/b \"c\".sesession"},
                    {{"lesson:tour", 3}, {"/my.lesson.md", 0}}};
    CHECK(keptStateFromJson(keptStateToJson(state)) == state);
    for (const char* bad : {"", "[]", "{", R"({"layout": 3, "recent": [1, {}], "lessons": 3})"}) {
        CAPTURE(bad);
        CHECK(keptStateFromJson(bad) == KeptState{});
    }
}

TEST_CASE("The state file is in the XDG folder, which is made with it") {
    const std::filesystem::path folder = test::ownPlace("state-test");
    std::filesystem::remove_all(folder);
    setenv("XDG_STATE_HOME", folder.c_str(), 1);
    CHECK(statePath() == folder / "spiraling-edge" / "state.json");
    CHECK(readKeptState(statePath()) == KeptState{});
    const KeptState state{LayoutPreset::Learn, {"/a.ply"}, {}};
    REQUIRE(writeKeptState(statePath(), state).ok());
    CHECK(readKeptState(statePath()) == state);
    CHECK(writeKeptState({}, state).ok());
    std::filesystem::remove_all(folder);
    unsetenv("XDG_STATE_HOME");
}
