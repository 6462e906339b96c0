#include "panel_state/settings.h"
#include "open_session.h"
#include "run/strings.h"

#include <doctest/doctest.h>

#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "spiraling_edge/base/atomic_file.h"

using namespace se::view;
using nlohmann::json;

TEST_CASE("Settings are read back as written") {
    ViewSettings settings;
    settings.theme = Theme::Light;
    settings.uiScale = 1.5;
    settings.width = 1600;
    settings.height = 900;
    settings.playRate = 15.0;
    settings.legend = false;
    settings.panels.column = 17.5F;
    settings.panels.folded = true;
    setOpen(settings.parts, *partNamed("Rings"), true);
    setOpen(settings.parts, *partNamed("Dial"), false);
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
    CHECK(read.value().parts == settings.parts);
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
    const test::OwnFolder folder;
    setenv("XDG_CONFIG_HOME", folder.path().c_str(), 1);
    CHECK(settingsPath() == folder / "spiraling-edge" / "settings.json");
    CHECK(readSettings(settingsPath()).complaints.empty());
    ViewSettings settings;
    settings.width = 999;
    REQUIRE(writeSettings(settingsPath(), {}, settings).ok());
    CHECK(readSettings(settingsPath()).width == 999);
    setenv("XDG_CONFIG_HOME", "relative", 1);
    CHECK(settingsPath() != std::filesystem::path("relative") / "spiraling-edge" / "settings.json");
    unsetenv("XDG_CONFIG_HOME");
}

namespace {

/// A folder with one file of the program's own, removed at the end.
class KeptFolder {
  public:
    std::filesystem::path file(const std::string& name = "settings.json") const {
        return folder_ / name;
    }
    void put(const std::string& text, const std::string& name = "settings.json") const {
        REQUIRE(se::writeFileAtomically(file(name), text).ok());
    }
    std::string text(const std::string& name = "settings.json") const {
        return readText(file(name)).value_or("none");
    }
    json content() const { return json::parse(text()); }
    /// Writes another width, as the window does at its end. Returns the first complaint about the
    /// old file.
    std::string runWindow(int width) const {
        const ViewSettings before = readSettings(file());
        ViewSettings settings = before;
        settings.width = width;
        REQUIRE(writeSettings(file(), before, settings).ok());
        return before.complaints.empty() ? "" : before.complaints.front();
    }

  private:
    test::OwnFolder folder_;
};

bool keptSays(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("Damaged settings are kept beside the file, reported once, and never lost") {
    const KeptFolder folder;
    const std::string deep = "{\"keys\": " + std::string(100000, '[');
    for (const std::string& damaged :
         {std::string("{\"theme\": \"light\",\n\"keys\" {\"edit.undo\": \"F7\"}}"),
          std::string("[1]"), std::string("\x1b[31m\xff"), std::string(R"({"version": "one"})"),
          std::string(R"({"version": 0})"), std::string(R"({"uiScale": 1e400})"), deep}) {
        std::filesystem::remove(folder.file("settings.json.bad"));
        folder.put(damaged);
        const std::string complaint = folder.runWindow(1000);
        CHECK(complaint.starts_with("settings.json: "));
        CHECK(keptSays(complaint, "settings.json.bad"));
        CHECK(complaint.size() < 400);
        CHECK(folder.text("settings.json.bad") == damaged);
        CHECK(folder.content()["width"] == 1000);
        CHECK(folder.runWindow(1001) == "");
    }
    CHECK(folder.text("settings.json.2.bad") == "none");
}

TEST_CASE("Another damaged file does not replace the one that was kept, an equal one needs none") {
    const KeptFolder folder;
    for (const char* damaged : {"{first", "{first", "{second", "{first"}) {
        folder.put(damaged);
        folder.runWindow(1000);
    }
    CHECK(folder.text("settings.json.bad") == "{first");
    CHECK(folder.text("settings.json.2.bad") == "{second");
    CHECK(folder.text("settings.json.3.bad") == "none");
}

TEST_CASE("Settings of a newer version are left as they are, and reported") {
    const KeptFolder folder;
    for (const std::string newer :
         {R"({"version": 2, "theme": {"name": "light"}})", R"({"version": 1e30})"}) {
        folder.put(newer);
        const std::string complaint = folder.runWindow(1000);
        CHECK(keptSays(complaint, "settings.json was written by a newer version"));
        CHECK(folder.text() == newer);
        CHECK(folder.text("settings.json.bad") == "none");
    }
}

TEST_CASE("Fields of others and values that are not understood stay in the settings") {
    const KeptFolder folder;
    folder.put(R"({"version": 1, "theme": "sepia", "color": [1, 2], "width": 900,
        "keys": {"edit.later": "F7", "step.pivot.next": "F99"}, "panels": {"attic": 3},
        "layers": {"fog": "on"}, "meshStyle": "flat"})");
    const json before = folder.content();
    folder.runWindow(900);
    CHECK(folder.content() == before);
    const ViewSettings read = readSettings(folder.file());
    ViewSettings settings = read;
    settings.width = 1000;
    settings.theme = Theme::Light;
    settings.meshStyle = MeshStyle::Flat;
    modeOf(settings.layers, LayerId::Normals) = LayerMode::PinnedOn;
    settings.panels.folded = true;
    REQUIRE(writeSettings(folder.file(), read, settings).ok());
    json expected = before;
    expected["width"] = 1000;
    expected["theme"] = "light";
    expected["usualMeshStyle"] = "faults";
    expected["layers"]["normals"] = layerModeName(LayerMode::PinnedOn);
    expected["panels"]["columnFolded"] = true;
    CHECK(folder.content() == expected);
    CHECK(readSettings(folder.file()).meshStyle == MeshStyle::Flat);
}

TEST_CASE("Keys that are reset leave those of others in the settings") {
    const KeptFolder folder;
    folder.put(R"({"keys": {"edit.later": "F7", "step.pivot.next": "F8"}})");
    const ViewSettings read = readSettings(folder.file());
    ViewSettings settings = read;
    settings.keys.resetAll();
    REQUIRE(writeSettings(folder.file(), read, settings).ok());
    CHECK(folder.content()["keys"] == json{{"edit.later", "F7"}});
}

TEST_CASE("What another window has kept meanwhile stays, unless it was changed here too") {
    const KeptFolder folder;
    folder.put(R"({"theme": "dark", "width": 900})");
    const ViewSettings read = readSettings(folder.file());
    folder.put(R"({"theme": "light", "width": 901})");
    ViewSettings settings = read;
    settings.width = 1000;
    REQUIRE(writeSettings(folder.file(), read, settings).ok());
    CHECK(folder.content()["theme"] == "light");
    CHECK(folder.content()["width"] == 1000);
}

TEST_CASE("Settings that are no file are left alone, empty ones are as none") {
    const KeptFolder folder;
    for (const char* empty : {"", " \n"}) {
        folder.put(empty);
        CHECK(folder.runWindow(1000) == "");
        CHECK(folder.content()["width"] == 1000);
        CHECK(folder.text("settings.json.bad") == "none");
    }
    std::filesystem::remove(folder.file());
    create_directories(folder.file() / "inside");
    CHECK(keptSays(folder.runWindow(1000), "settings.json is no regular file"));
    CHECK(exists(folder.file() / "inside"));
    remove_all(folder.file());
    std::filesystem::create_symlink("/dev/zero", folder.file());
    CHECK(keptSays(folder.runWindow(1000), "settings.json is no regular file"));
    CHECK(is_symlink(folder.file()));
    // A link to a file stays one.
    std::filesystem::remove(folder.file());
    folder.put("{broken", "elsewhere.json");
    std::filesystem::create_symlink("elsewhere.json", folder.file());
    folder.runWindow(1000);
    CHECK(is_symlink(folder.file()));
    CHECK(folder.text("settings.json.bad") == "{broken");
    CHECK(json::parse(folder.text("elsewhere.json"))["width"] == 1000);
}

TEST_CASE("The state of the program is kept by the rules of the settings") {
    const KeptFolder folder;
    KeptFile file;
    file.open(folder.file());
    const auto addFile = [](KeptState& state) { remember(state, "/a.ply"); };
    CHECK(file.complaint() == "");
    folder.put(R"({"recent": ["/b.ply"], "lessons": {"x": "soon", "y": 2}, "tabs": [1]})");
    REQUIRE(file.change(addFile).ok());
    CHECK(folder.content() == json::parse(R"({"version": 1, "recent": ["/a.ply", "/b.ply"],
        "lessons": {"x": "soon", "y": 2}, "tabs": [1]})"));
    const std::string newer = R"({"version": 2, "recent": {}})";
    folder.put(newer);
    CHECK(keptSays(file.complaint(), "newer version"));
    REQUIRE(file.change(addFile).ok());
    CHECK(folder.text() == newer);
    folder.put("{broken");
    CHECK(keptSays(file.complaint(), "settings.json.bad"));
    REQUIRE(file.change(addFile).ok());
    CHECK(folder.text("settings.json.bad") == "{broken");
    CHECK(file.read().recent == std::vector<std::string>{"/a.ply"});
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
    const test::OwnFolder folder;
    setenv("XDG_STATE_HOME", folder.path().c_str(), 1);
    CHECK(statePath() == folder / "spiraling-edge" / "state.json");
    CHECK(readKeptState(statePath()) == KeptState{});
    const KeptState state{LayoutPreset::Present, {"/a.ply"}, {}};
    KeptFile file;
    const auto setState = [&](KeptState& kept) { kept = state; };
    CHECK(file.change(setState).ok());
    file.open(statePath());
    REQUIRE(file.change(setState).ok());
    CHECK(readKeptState(statePath()) == state);
    unsetenv("XDG_STATE_HOME");
}
