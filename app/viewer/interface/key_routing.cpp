#include "key_routing.h"

#include <set>
#include <string_view>

namespace se::view {

namespace {

constexpr int kFirstNamedKey = key::kEscape;
constexpr int kFirstModifierKey = 340;
constexpr int kLeftShift = 340;
constexpr int kRightShift = 344;
constexpr std::string_view kEditLetters = "ACVXYZ";

bool isPlain(const KeyChord& chord) { return (chord.mods & (kCtrl | kAlt)) == 0; }

/// Signs come by themselves; of other keys only the state is looked at.
bool isLookedAt(const KeyPress& press) {
    const int key = press.rawKey;
    if (key >= kFirstNamedKey) return key < kFirstModifierKey;
    return (press.chord.mods & kCtrl) != 0;
}

}  // namespace

bool isShiftKey(int key) { return key == kLeftShift || key == kRightShift; }

std::size_t pressesOfNextFrame(std::span<const KeyPress> waiting) {
    std::set<int> down;
    std::set<int> up;
    for (std::size_t i = 0; i < waiting.size(); ++i) {
        const KeyPress& press = waiting[i];
        if (press.sign != 0 || press.repeated) continue;
        if (press.released) {
            if (down.contains(press.rawKey)) return i;
            up.insert(press.rawKey);
        } else if (isLookedAt(press)) {
            if (up.contains(press.rawKey)) return i;
            down.insert(press.rawKey);
        }
    }
    return waiting.size();
}

bool editsText(const KeyChord& chord) {
    if (chord.isFunctionKey()) return false;
    if (isPlain(chord) || chord.key >= kFirstNamedKey) return true;
    // With both held some keyboards write a sign.
    const bool both = (chord.mods & kCtrl) != 0 && (chord.mods & kAlt) != 0;
    const bool letter = chord.key > 0 && chord.key < 128 &&
                        kEditLetters.find(static_cast<char>(chord.key)) != std::string_view::npos;
    return both || ((chord.mods & kCtrl) != 0 && letter);
}

bool reachesActions(const KeyChord& chord, const Keyboard& keyboard) {
    if (chord.key == key::kEscape) return true;
    // It walks on from panel to panel.
    if (chord.key == key::kTab) return !keyboard.textField && !keyboard.dialog;
    if (keyboard.textField && editsText(chord)) return false;
    const bool plain = isPlain(chord) && !chord.isFunctionKey();
    return !(plain && (keyboard.dialog || keyboard.panel));
}

}  // namespace se::view
