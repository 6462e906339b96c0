#include "commands/commands.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <sstream>

#include "document/ui_state.h"
#include "headless_app.h"
#include "scene/camera.h"
#include "session/playback.h"

using namespace se;
using namespace se::view;

namespace {

std::vector<std::string> keysOf(const Command& command) {
    std::istringstream words{std::string(command.keys)};
    std::vector<std::string> keys;
    for (std::string word; words >> word;) keys.push_back(word);
    return keys;
}

struct CommandApp {
    test::OpenSession open;
    test::AroundSession around{open.session};
    Playback& playback = around.playback;
    Camera& camera = around.camera;
    UiState& ui = around.ui;
    CommandContext& context = around.context;

    void press(const char* key) {
        const Command* command = KeyMap().commandFor(*keyFromString(key));
        REQUIRE(command != nullptr);
        command->run(context);
    }
};

std::vector<PaletteEntry> found(std::string_view filter) {
    return matchingEntries(paletteEntries(), filter);
}

bool finds(std::string_view filter, std::string_view id) {
    const auto all = found(filter);
    return std::any_of(all.begin(), all.end(),
                       [&](const PaletteEntry& each) { return each.id == id; });
}

}  // namespace

TEST_CASE("No key belongs to two commands, and every key can be read and written") {
    std::map<std::string, std::string_view> owner;
    for (const Command& command : commands()) {
        for (const std::string& key : keysOf(command)) {
            CAPTURE(key);
            const auto chord = keyFromString(key);
            REQUIRE(chord.has_value());
            CHECK(toString(*chord) == key);
            CHECK(owner.emplace(key, command.id).second);
            CHECK(KeyMap().commandFor(*chord) == &command);
        }
    }
}

TEST_CASE("Every command has a name of its own, a title and a sentence of help") {
    std::set<std::string_view> ids;
    for (const Command& command : commands()) {
        CAPTURE(std::string(command.id));
        CHECK(ids.insert(command.id).second);
        CHECK_FALSE(command.title.empty());
        CHECK(command.help.ends_with('.'));
        CHECK((command.run != nullptr));
        CHECK(findCommand(command.id) == &command);
    }
}

TEST_CASE("Texts that are no keys are refused") {
    for (const char* text : {"", "Ctrl+", "F0", "F25", "Homer", "ab", "Hyper+F"}) {
        CAPTURE(text);
        CHECK(keyFromString(text) == std::nullopt);
    }
}

TEST_CASE("The conventional keys have their usual effect") {
    CommandApp app;
    app.press("F10");
    app.press(".");
    CHECK(app.open.place() == "2.advance.1");
    app.press("Shift+F10");
    CHECK(app.open.place() == "1.advance.1");
    app.press("Right");
    CHECK(app.open.place() == "2.pivot.1");
    app.press("Shift+F11");
    CHECK(app.open.place() == "2.advance.1");
    app.press("Home");
    CHECK(app.open.place() == "start");
    app.press("F5");
    app.open.session.waitUntilDone();
    CHECK(app.open.session.atEnd());
}

TEST_CASE("Stepping by hand pauses playing") {
    CommandApp app;
    app.press("Space");
    CHECK(app.playback.playing());
    app.press("F11");
    CHECK_FALSE(app.playback.playing());
}

TEST_CASE("Esc closes, then clears, then leaves Present, and never quits") {
    CommandApp app;
    app.press("F1");
    CHECK(app.ui.help == HelpPage::Keys);
    app.open.session.select(3);
    app.press("Esc");
    CHECK(app.ui.help == HelpPage::None);
    CHECK(app.open.session.selected() == 3);
    app.ui.layoutPreset = LayoutPreset::Present;
    app.press("Esc");
    CHECK(app.open.session.selected() == kNone);
    CHECK(app.ui.layoutPreset == LayoutPreset::Present);
    app.press("Esc");
    CHECK(app.ui.layoutPreset == LayoutPreset::Debug);
    app.press("Esc");
    CHECK_FALSE(app.ui.quitting);
    app.press("Ctrl+Q");
    CHECK(app.ui.quitting);
}

TEST_CASE("Layer keys switch their layer") {
    CommandApp app;
    const auto shown = [&] { return shownLayers(app.ui.settings.layers, std::nullopt); };
    const LayerSwitches before = shown();
    for (const char* key : {"N", "L", "E", "S", "G", "K"}) app.press(key);
    CHECK((before ^ shown()).count() == 6);
    for (const char* key : {"N", "L", "E", "S", "G", "K"}) app.press(key);
    CHECK(app.ui.settings.layers == LayerModes{});
}

TEST_CASE("Framing moves the camera to the selection or the pivot, stepping does not") {
    CommandApp app;
    const Camera before = app.camera;
    app.press("F10");
    CHECK(app.camera == before);
    app.open.session.select(9);
    app.press("F");
    CHECK(app.ui.cameraMove.active());
    for (const double now : {0.0, 2.0 * kMoveSeconds}) app.ui.cameraMove.apply(app.camera, now);
    const glm::vec3 selected = app.open.session.model().place[9];
    CHECK(glm::distance(app.camera.target(), selected) < 0.2F * app.camera.distance());
    CHECK(app.camera.distance() < 0.5F * before.distance());
    app.press("Shift+F");
    CHECK(glm::length(app.camera.target()) < 0.1F);
}

TEST_CASE("The list of actions names each one once") {
    const std::string list = listActions();
    for (const Command& command : commands()) {
        CAPTURE(std::string(command.id));
        CHECK((list.find("\n" + std::string(command.id) + " ") != std::string::npos ||
               list.starts_with(std::string(command.id) + " ")));
    }
}

TEST_CASE("The palette finds actions by words, those in the title first") {
    CHECK(found("").size() == paletteEntries().size());
    CHECK(found("no such action").empty());
    const auto pivots = found("PIVOT next");
    REQUIRE_FALSE(pivots.empty());
    CHECK(pivots.front().id == "step.pivot.next");
    // The name of a panel finds the panel first, not actions about it.
    CHECK(found("rules").front().id == "view.rules");
    CHECK(found("Watch").front().id == "view.watch");
    for (const PaletteEntry& each : found("normals")) {
        if (each.kind != PaletteEntry::Kind::Action) continue;
        CAPTURE(std::string(each.id));
        CHECK(each.id == "layer.normals");
    }
}

TEST_CASE("The palette finds by the beginnings of words, not by their middle") {
    CHECK(finds("scr", "file.screenshot"));
    CHECK_FALSE(finds("creenshot", "file.screenshot"));
    // "up" is in "support" and "duplicate", but begins other words.
    CHECK(found("up").front().title.starts_with("Up"));
    for (const PaletteEntry& each : found("up")) CHECK(each.id != "duplicates");
}

TEST_CASE("The palette finds by synonyms") {
    struct Other {
        const char* word;
        const char* id;
    };
    for (const Other& each : {Other{"hole", "view.alerts"},
                              {"wireframe", "view.mesh.wire"},
                              {"export", "file.savepoints"},
                              {"record", "file.screenshot"},
                              {"save", "file.save"},
                              {"up", "view.up.y"},
                              {"upright", "view.up.auto"},
                              {"exit", "file.quit"},
                              {"shortcuts", "help.keys"},
                              {"zoom", "view.frame"}}) {
        CAPTURE(each.word);
        CHECK(finds(each.word, each.id));
    }
}

TEST_CASE("The palette shows panels, and opens scenes and figures") {
    CommandApp app;
    const auto choosing = [&](const char* words, PaletteEntry::Kind kind) {
        const auto all = found(words);
        REQUIRE_FALSE(all.empty());
        CHECK(all.front().kind == kind);
        choose(all.front(), app.context);
    };
    choosing("dial", PaletteEntry::Kind::Panel);
    CHECK(app.ui.column.part == "Dial");
    app.ui.layoutPreset = LayoutPreset::Present;
    choosing("steps", PaletteEntry::Kind::Panel);
    CHECK(app.ui.layoutPreset == LayoutPreset::Debug);
    choosing("figure 12", PaletteEntry::Kind::Scene);
    CHECK(app.open.session.input().opening().source == "scene:figure-12");
    choosing("hole of four", PaletteEntry::Kind::Scene);
    CHECK(app.open.session.input().opening().source == "scene:four-edge-hole");
    // A panel opened by an action is listed once.
    const auto rules = found("rules");
    CHECK(std::count_if(rules.begin(), rules.end(),
                        [](const PaletteEntry& each) { return each.title == "Rules"; }) == 1);
    // The others are chosen as before.
    choosing("dark or light", PaletteEntry::Kind::Action);
    CHECK(app.ui.settings.theme == Theme::Light);
}

TEST_CASE("What cannot act says why") {
    CommandApp app;
    const auto why = [&](const char* id) {
        return std::string(whyUnavailable(*findCommand(id), app.context));
    };
    CHECK(why("help.keys").empty());
    CHECK(why("run.play").empty());
    CHECK(why("run.start") == "This is the start of the run.");
    CHECK(why("edit.undo") == "There is nothing to undo.");
    CHECK(why("edit.redo") == "There is nothing to redo.");
    CHECK(why("edit.rules.reset") == "All rules have the values of their set.");
    CHECK(why("edit.whatif.clear") == "No what-ifs are active.");
    CHECK(why("run.compare.stop") == "Nothing is compared.");
    app.open.session.moves().toEnd();
    app.open.session.waitUntilDone();
    CHECK(why("run.play") == "The run is finished.");
    CHECK(why("run.start").empty());
    CHECK(why("step.alert.next").empty());
    Session none;
    const CommandContext nothing = app.context.of(none);
    CHECK(whyUnavailable(*findCommand("ask.why"), nothing) == "Nothing is open.");
    CHECK(whyUnavailable(*findCommand("file.open"), nothing).empty());
}

TEST_CASE("Ctrl+P opens the palette, and Esc closes it") {
    CommandApp app;
    app.press("Ctrl+P");
    CHECK(app.ui.palette.open);
    app.press("Esc");
    CHECK_FALSE(app.ui.palette.open);
}
