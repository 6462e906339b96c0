#include "interface/key_routing.h"

#include <doctest/doctest.h>

#include <vector>

using namespace se::view;

namespace {

KeyChord chord(const char* text) { return *keyFromString(text); }

KeyPress down(const char* text) {
    KeyPress press;
    press.chord = chord(text);
    press.rawKey = press.chord.key;
    return press;
}

KeyPress up(const char* text) {
    KeyPress press = down(text);
    press.released = true;
    return press;
}

KeyPress sign(unsigned code) {
    KeyPress press;
    press.sign = code;
    return press;
}

}  // namespace

TEST_CASE("A text field keeps what edits it; other chords and function keys go on") {
    const Keyboard typing{true, false, false};
    for (const char* mine : {"A", "Shift+A", "Space", "Enter", "Ctrl+C", "Ctrl+V", "Ctrl+X",
                             "Ctrl+A", "Ctrl+Z", "Ctrl+Shift+Z", "Ctrl+Y", "Left", "Ctrl+Left",
                             "Alt+Right", "Ctrl+Home", "Ctrl+Backspace", "Ctrl+Alt+Q"}) {
        CAPTURE(mine);
        CHECK_FALSE(reachesActions(chord(mine), typing));
    }
    for (const char* free :
         {"Ctrl+S", "Ctrl+Q", "Ctrl+P", "Ctrl+1", "F1", "F10", "Shift+F5", "Ctrl+O", "Esc"}) {
        CAPTURE(free);
        CHECK(reachesActions(chord(free), typing));
    }
}

TEST_CASE("Behind a dialog, and while somebody walks through a panel, plain keys do nothing") {
    for (const Keyboard& keyboard : {Keyboard{false, true, false}, Keyboard{false, false, true}}) {
        CHECK_FALSE(reachesActions(chord("N"), keyboard));
        CHECK_FALSE(reachesActions(chord("Space"), keyboard));
        CHECK_FALSE(reachesActions(chord("Right"), keyboard));
        CHECK(reachesActions(chord("Esc"), keyboard));
        CHECK(reachesActions(chord("Ctrl+Q"), keyboard));
        CHECK(reachesActions(chord("F1"), keyboard));
    }
    CHECK(reachesActions(chord("N"), {}));
}

TEST_CASE("A key that comes down and goes up within one frame is seen in two") {
    const std::vector<KeyPress> enter = {down("Enter"), up("Enter")};
    CHECK(pressesOfNextFrame(enter) == 1);
    const std::vector<KeyPress> rest = {up("Enter")};
    CHECK(pressesOfNextFrame(rest) == 1);
    const std::vector<KeyPress> twice = {up("Down"), down("Down"), up("Down")};
    CHECK(pressesOfNextFrame(twice) == 1);
    const std::vector<KeyPress> chorded = {down("Ctrl+A"), up("A"), sign('x')};
    CHECK(pressesOfNextFrame(chorded) == 1);
}

TEST_CASE("What is typed goes on in one frame, up to the key that ends it") {
    const std::vector<KeyPress> typed = {down("A"), sign('a'), up("A"),       down("A"),
                                         sign('a'), up("A"),   down("Enter"), up("Enter")};
    CHECK(pressesOfNextFrame(typed) == 7);
    CHECK(pressesOfNextFrame({}) == 0);
    KeyPress again = down("Right");
    again.repeated = true;
    const std::vector<KeyPress> held = {down("Right"), again, again};
    CHECK(pressesOfNextFrame(held) == 3);
}
