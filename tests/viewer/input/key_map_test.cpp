#include "input/key_map.h"

#include <doctest/doctest.h>

#include "chord.h"
#include "commands/commands.h"
#include "panel_state/settings.h"

using namespace se::view;
using namespace se::view::test;

namespace {

const Command& command(const char* id) {
    const Command* found = findCommand(id);
    REQUIRE(found != nullptr);
    return *found;
}

}  // namespace

TEST_CASE("Without changes the keys are those of the table") {
    const KeyMap map;
    for (const Command& each : commands()) {
        CAPTURE(std::string(each.id));
        CHECK(map.keysOf(each) == each.keys);
        CHECK(map.first(each) == each.keys.substr(0, each.keys.find(' ')));
        CHECK_FALSE(map.isChanged(each));
    }
}

TEST_CASE("A bound key is removed from the action that had it, reset brings both back") {
    KeyMap map;
    const Command& next = command("step.pivot.next");
    const Command& play = command("run.play");
    map.bind(next, chord("P"));
    CHECK(map.all(next) == "P");
    CHECK(map.all(play) == "Space");
    CHECK(map.commandFor(chord("P")) == &next);
    CHECK(map.commandFor(chord("F10")) == nullptr);
    map.reset(play);
    CHECK(map.all(play) == "Space, P");
    CHECK(map.all(next).empty());
    map.reset(next);
    CHECK(map.changes().empty());
}

TEST_CASE("No key belongs to two actions after any binding") {
    KeyMap map;
    for (const char* key : {"F10", "Space", "Ctrl+S", "N", "F10"}) {
        for (const char* id : {"view.home", "run.play", "layer.labels"}) {
            map.bind(command(id), chord(key));
            int owners = 0;
            for (const Command& each : commands()) {
                const std::string all = ", " + map.all(each) + ", ";
                if (all.find(", " + std::string(key) + ", ") != std::string::npos) ++owners;
            }
            CHECK(owners == 1);
        }
    }
}

TEST_CASE("Changes go through the settings and back") {
    ViewSettings settings;
    settings.keys.bind(command("step.pivot.next"), chord("Ctrl+J"));
    settings.keys.unbind(command("view.theme"));
    const auto read = settingsFromJson(settingsToJson(settings));
    REQUIRE(read.ok());
    CHECK(read.value().keys == settings.keys);
    CHECK(read.value().complaints.empty());
}

TEST_CASE("Errors about keys in the settings are reported, and all else is used") {
    KeyMap map;
    const auto complaints = map.load({{"no.such.action", "F4"},
                                      {"step.pivot.next", "F8 Nonsense"},
                                      {"view.home", "F7"},
                                      {"view.theme", "F7"}});
    REQUIRE(complaints.size() == 3);
    CHECK(complaints[0].find("no.such.action") != std::string::npos);
    CHECK(complaints[1].find("Nonsense") != std::string::npos);
    CHECK(complaints[2].find("F7") != std::string::npos);
    CHECK(map.all(command("step.pivot.next")) == "F8");
    CHECK(map.commandFor(chord("F7")) == &command("view.home"));
}

TEST_CASE("A conflict is named, and the same key a second time resolves it") {
    KeyMap map;
    KeyCapture capture;
    capture.begin("step.pivot.next");
    REQUIRE(capture.active());
    capture.press({340, kShift}, map);  // Shift by itself is no key.
    CHECK(capture.active());
    capture.press(chord("Ctrl+S"), map);
    CHECK(capture.active());
    CHECK(capture.note().find("Save session") != std::string::npos);
    CHECK(map.changes().empty());
    capture.press(chord("Ctrl+S"), map);
    CHECK_FALSE(capture.active());
    CHECK(map.all(command("step.pivot.next")) == "Ctrl+S");
    CHECK(map.all(command("file.save")).empty());
}

TEST_CASE("Esc keeps a key, Backspace removes it, nameless keys are refused") {
    KeyMap map;
    KeyCapture capture;
    capture.begin("view.theme");
    capture.press({key::kEscape, kNoMods}, map);
    CHECK_FALSE(capture.active());
    CHECK(map.changes().empty());
    capture.begin("view.theme");
    capture.press({320, kNoMods}, map);
    CHECK(capture.active());
    CHECK(capture.note().find("no name") != std::string::npos);
    capture.press({key::kBackspace, kNoMods}, map);
    CHECK_FALSE(capture.active());
    CHECK(map.all(command("view.theme")).empty());
}

TEST_CASE("The keys of a presenter's remote control step, blank the screen and go to the start") {
    CHECK(presenterCommandFor(chord("PageDown")) == findCommand("step.event.next"));
    CHECK(presenterCommandFor(chord("PageUp")) == findCommand("step.event.previous"));
    CHECK(presenterCommandFor(chord("B")) == findCommand("view.black"));
    CHECK(presenterCommandFor(chord(".")) == findCommand("view.black"));
    CHECK(presenterCommandFor(chord("W")) == findCommand("view.white"));
    CHECK(presenterCommandFor(chord("F5")) == findCommand("run.start"));
    CHECK(presenterCommandFor(chord("Shift+F5")) == findCommand("view.layout.present"));
    // All others are those of every layout.
    CHECK(presenterCommandFor(chord("F10")) == nullptr);
    CHECK(presenterCommandFor(chord("Esc")) == nullptr);
}
