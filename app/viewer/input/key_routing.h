/// What a key goes to: a text field, a dialog, a panel or an action; and how keys are handed to a
/// user interface that looks only once per frame. Plain values.
#pragma once

#include <span>

#include "keys.h"

namespace se::view {

/// A key, or a sign typed, as the window hears of it.
struct KeyPress {
    KeyChord chord;
    bool repeated = false;
    unsigned sign = 0;  ///< 0: a key.
    bool released = false;
    int rawKey = 0;  ///< By its place on the keyboard, not by what is printed on it.
    int scancode = 0;
    int rawMods = 0;
};

/// How many of those that wait go into the next frame; the order stays. A user interface that looks
/// at the state of keys once per frame sees of Ctrl down, V down, Ctrl up, V up nothing at all, and
/// of two keys one. So a frame has at most one key whose state is looked at; its release, what
/// modifiers do after it, and what is typed after it wait for the frame after.
std::size_t pressesOfNextFrame(std::span<const KeyPress> waiting);

/// True for the sign that comes with the press of a key just before it: it is of no use once that
/// press has run an action. Requires i < presses.size().
bool isSignOfKeyBefore(std::span<const KeyPress> presses, std::size_t i);

/// Who has the keyboard.
struct Keyboard {
    bool textField = false;  ///< Somebody types.
    bool dialog = false;     ///< A window lies over the view.
    bool panel = false;      ///< Somebody walks through a panel by keyboard.
};

/// True for either Shift key by itself.
bool isShiftKey(int key);
/// True for what changes a text or moves in it: plain keys, Ctrl+C and the like.
bool editsText(const KeyChord& chord);
/// True if a key may run an action. Esc always may.
bool reachesActions(const KeyChord& chord, const Keyboard& keyboard);

}  // namespace se::view
