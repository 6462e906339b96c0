#include "input/key_routing.h"

#include <doctest/doctest.h>

#include <vector>

#include "chord.h"
#include "commands/commands.h"
#include "document/document.h"
#include "headless_app.h"

using namespace se::view;
using namespace se::view::test;

namespace {

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

/// Left Ctrl by itself, 341 to the window.
KeyPress ctrl(bool released) {
    KeyPress press;
    press.chord = {341, released ? kNoMods : kCtrl};
    press.rawKey = 341;
    press.released = released;
    return press;
}

/// Number of presses that each frame gets.
std::vector<std::size_t> frames(std::vector<KeyPress> waiting) {
    std::vector<std::size_t> sizes;
    while (!waiting.empty()) {
        sizes.push_back(pressesOfNextFrame(waiting));
        REQUIRE(sizes.back() > 0);
        waiting.erase(waiting.begin(), waiting.begin() + static_cast<long>(sizes.back()));
    }
    return sizes;
}

KeyPress sign(unsigned code) {
    KeyPress press;
    press.sign = code;
    return press;
}

}  // namespace

TEST_CASE("A text field keeps editing keys, other chords and function keys pass") {
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

TEST_CASE("Under a dialog, and during keyboard navigation of a panel, plain keys have no effect") {
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

TEST_CASE("A key that comes down and goes up within one frame is delivered in two") {
    const std::vector<KeyPress> enter = {down("Enter"), up("Enter")};
    CHECK(pressesOfNextFrame(enter) == 1);
    const std::vector<KeyPress> rest = {up("Enter")};
    CHECK(pressesOfNextFrame(rest) == 1);
    const std::vector<KeyPress> twice = {up("Down"), down("Down"), up("Down")};
    CHECK(pressesOfNextFrame(twice) == 1);
    const std::vector<KeyPress> chorded = {down("Ctrl+A"), up("A"), sign('x')};
    CHECK(pressesOfNextFrame(chorded) == 1);
}

TEST_CASE("Typed text is delivered in one frame, up to the key that ends it") {
    const std::vector<KeyPress> typed = {down("A"), sign('a'), up("A"),       down("A"),
                                         sign('a'), up("A"),   down("Enter"), up("Enter")};
    CHECK(pressesOfNextFrame(typed) == 7);
    CHECK(pressesOfNextFrame({}) == 0);
    KeyPress again = down("Right");
    again.repeated = true;
    const std::vector<KeyPress> held = {down("Right"), again, again};
    CHECK(pressesOfNextFrame(held) == 3);
}

TEST_CASE("A chord is delivered whole, in any order of its releases") {
    using Sizes = std::vector<std::size_t>;
    // Ctrl is down in the frame in which V comes down, and until its end.
    CHECK(frames({ctrl(false), down("Ctrl+V"), ctrl(true), up("V")}) == Sizes{2, 2});
    CHECK(frames({ctrl(false), down("Ctrl+V"), up("V"), ctrl(true)}) == Sizes{2, 2});
    // Two of them, with one Ctrl, and with one each.
    CHECK(frames({ctrl(false), down("Ctrl+A"), up("A"), down("Ctrl+C"), up("C"), ctrl(true)}) ==
          Sizes{2, 2, 2});
    CHECK(frames({ctrl(false), down("Ctrl+A"), ctrl(true), up("A"), ctrl(false), down("Ctrl+V"),
                  ctrl(true), up("V")}) == Sizes{2, 4, 2});
    // A key that is down before Ctrl is no chord.
    CHECK(frames({down("Left"), ctrl(false), up("Left"), ctrl(true)}) == Sizes{1, 3});
}

TEST_CASE("Text typed before and after a chord or an arrow keeps its order") {
    using Sizes = std::vector<std::size_t>;
    // While Ctrl is down nothing is typed, so earlier text must be in.
    CHECK(frames({down("X"), sign('x'), up("X"), ctrl(false), down("Ctrl+A"), ctrl(true), up("A"),
                  down("Y"), sign('y')}) == Sizes{3, 2, 4});
    // Within one frame the character would come first.
    CHECK(frames({down("Left"), down("X"), sign('x'), up("Left"), up("X")}) == Sizes{2, 3});
    // Of two keys in one frame only one would count.
    CHECK(frames({down("Left"), down("Backspace"), up("Left"), up("Backspace")}) == Sizes{1, 2, 1});
}

TEST_CASE("A character acts by itself where the layout has it on another key") {
    const auto typed = [](const char* key, char typedSign, int mods) {
        KeyPress press = down(key);
        press.sign = static_cast<unsigned char>(typedSign);
        press.rawMods = mods;
        return chordOfSign(press);
    };
    // French: digits and the period with Shift; German: the equals sign on 0.
    CHECK((typed("Shift+&", '1', kShift) == chord("1")));
    CHECK((typed("Shift+7", '7', kShift) == chord("7")));
    CHECK((typed("Shift+;", '.', kShift) == chord(".")));
    CHECK((typed("Shift+0", '=', kShift) == chord("=")));
    CHECK((typed("Ctrl+Shift+0", '=', kCtrl | kShift) == chord("Ctrl+=")));
    // AltGr is Ctrl and Alt in some systems.
    CHECK((typed("Ctrl+Alt+7", '{', kCtrl | kAlt) == KeyChord{'{', kNoMods}));
    // Where the key says so it has acted, and letters are named by keys.
    CHECK_FALSE(typed("1", '1', kNoMods).has_value());
    CHECK_FALSE(typed("Ctrl+=", '=', kCtrl).has_value());
    CHECK_FALSE(typed("Shift+N", 'N', kShift).has_value());
    CHECK((typed("Ctrl+Alt+Q", '@', kCtrl | kAlt) == chord("@")));
}

TEST_CASE("The character of a key belongs to its press, later text does not") {
    const std::vector<KeyPress> typed = {down("W"), sign('w'), up("W"), down("8"), sign('8')};
    CHECK(isSignOfKeyBefore(typed, 1));
    CHECK(isSignOfKeyBefore(typed, 4));
    for (const std::size_t other : {std::size_t{0}, std::size_t{2}, std::size_t{3}})
        CHECK_FALSE(isSignOfKeyBefore(typed, other));
    const std::vector<KeyPress> pasted = {sign('a'), sign('b')};
    CHECK_FALSE(isSignOfKeyBefore(pasted, 0));
    CHECK_FALSE(isSignOfKeyBefore(pasted, 1));
}

TEST_CASE("Keys wait from the command that opens a text field until the field takes them") {
    TypingWait wait;
    CHECK_FALSE(wait.waits());
    wait.open(TypedField::Query);
    CHECK(wait.waits());
    // The panel has requested the keyboard, but does not have it.
    CHECK_FALSE(wait.takeFocus(TypedField::Ledger));
    CHECK(wait.takeFocus(TypedField::Query));
    CHECK_FALSE(wait.takeFocus(TypedField::Query));
    wait.endFrame(false);
    CHECK(wait.waits());
    // It is active, but plain keys still go to actions.
    wait.takesKeys();
    wait.endFrame(false);
    CHECK(wait.waits());
    wait.takesKeys();
    wait.endFrame(true);
    CHECK_FALSE(wait.waits());
}

TEST_CASE("A text field that had the keyboard before does not end the wait for another one") {
    TypingWait wait;
    wait.open(TypedField::Dialog);
    wait.takesKeys();
    wait.endFrame(true);
    REQUIRE_FALSE(wait.waits());
    // The palette runs "Find decisions...": its own line is gone, the other one is about to appear.
    wait.open(TypedField::Query);
    CHECK(wait.waits());
    wait.endFrame(true);
    CHECK(wait.waits());
}

TEST_CASE("Keys do not wait forever for a text field that never appears") {
    TypingWait wait;
    wait.open(TypedField::Ledger);
    int frames = 0;
    for (; wait.waits() && frames < 100; ++frames) wait.endFrame(false);
    CHECK(frames > 4);
    CHECK(frames < 30);
}

TEST_CASE("All text fields that commands open are waited for") {
    for (const char* command : {"help.palette", "file.open", "file.saveas", "step.goto",
                                "ask.query", "ask.why", "file.prepare"}) {
        CAPTURE(command);
        test::HeadlessApp app("typing-test");
        app.document.open("scene:sphere");
        app.waitUntilDone();
        CHECK_FALSE(app.ui.typing.waits());
        runCommand(*findCommand(command), app.context);
        CHECK(app.ui.typing.waits());
    }
}
