// Dear ImGui 1.86 polls the state of keys once per frame and reads characters before it, so
// presses that arrive within one frame can hide each other. The window therefore queues presses,
// and a frame takes as many from the front of the queue as remain distinguishable in their order.

#include "key_routing.h"

#include <cassert>
#include <set>
#include <utility>

namespace se::view {

namespace {

constexpr int kFirstNamedKey = key::kEscape;
constexpr int kLeftShift = 340;
constexpr int kRightShift = 344;
constexpr std::string_view kEditLetters = "ACVXYZ";

bool isPlain(const KeyChord& chord) { return (chord.mods & (kCtrl | kAlt)) == 0; }

/// Characters arrive as events; for other keys only their state is polled.
bool isLookedAt(const KeyPress& press) {
    const int key = press.rawKey;
    if (key >= kFirstNamedKey) return key < key::kFirstModifier;
    return (press.chord.mods & kCtrl) != 0;
}

/// Input that one frame has received so far.
class FrameOfKeys {
  public:
    /// False if the press would hide an earlier one, or be hidden by it.
    bool take(const KeyPress& press) {
        if (press.sign != 0) {
            // Characters are read before the state of keys, and not at all while Ctrl is down.
            typed_ = true;
            return !pressed_;
        }
        if (press.repeated) return true;
        if (isShiftKey(press.rawKey)) return !pressed_;  // A character includes its Shift.
        if (isModifierKey(press.rawKey)) return !pressed_ && !typed_;
        if (press.released) {
            up_.insert(press.rawKey);
            return !down_.contains(press.rawKey);
        }
        if (!isLookedAt(press)) return true;
        const bool first = !pressed_ && !up_.contains(press.rawKey);
        pressed_ = true;
        down_.insert(press.rawKey);
        return first;
    }

  private:
    bool typed_ = false;
    bool pressed_ = false;  ///< A polled key has been pressed.
    std::set<int> down_;
    std::set<int> up_;
};

}  // namespace

bool isShiftKey(int key) { return key == kLeftShift || key == kRightShift; }

std::size_t pressesOfNextFrame(std::span<const KeyPress> waiting) {
    FrameOfKeys frame;
    for (std::size_t i = 0; i < waiting.size(); ++i) {
        if (!frame.take(waiting[i])) return i;
    }
    return waiting.size();
}

bool isSignOfKeyBefore(std::span<const KeyPress> presses, std::size_t i) {
    assert(i < presses.size());
    return presses[i].sign != 0 && i > 0 && presses[i - 1].sign == 0 && !presses[i - 1].released;
}

bool isText(const KeyPress& typed) {
    const int held = typed.rawMods & (kCtrl | kAlt);
    return held == 0 || held == (kCtrl | kAlt);
}

std::optional<KeyChord> chordOfSign(const KeyPress& typed) {
    const auto sign = static_cast<int>(typed.sign);
    const bool letter = (sign >= 'A' && sign <= 'Z') || (sign >= 'a' && sign <= 'z');
    // The back-quote is held down, at its position.
    if (letter || sign <= ' ' || sign > '~' || sign == '`') return std::nullopt;
    const KeyChord chord{sign, isText(typed) ? kNoMods : typed.rawMods & (kCtrl | kAlt)};
    if (chord == typed.chord) return std::nullopt;
    return chord;
}

bool editsText(const KeyChord& chord) {
    if (chord.isFunctionKey()) return false;
    if (isPlain(chord) || chord.key >= kFirstNamedKey) return true;
    // With both held some keyboards produce a character.
    const bool both = (chord.mods & kCtrl) != 0 && (chord.mods & kAlt) != 0;
    const bool letter = chord.key > 0 && chord.key < 128 &&
                        kEditLetters.find(static_cast<char>(chord.key)) != std::string_view::npos;
    return both || ((chord.mods & kCtrl) != 0 && letter);
}

bool reachesActions(const KeyChord& chord, const Keyboard& keyboard) {
    if (chord.key == key::kEscape) return true;
    // It moves on from panel to panel.
    if (chord.key == key::kTab) return !keyboard.textField && !keyboard.dialog;
    if (keyboard.textField && editsText(chord)) return false;
    const bool plain = isPlain(chord) && !chord.isFunctionKey();
    return !(plain && (keyboard.dialog || keyboard.panel));
}

namespace {

std::size_t placeOf(KeyStop stop) { return static_cast<std::size_t>(stop); }

}  // namespace

void KeyWalk::begin() {
    offered_ = std::exchange(fresh_, Offers{true});
    // Its panel is gone, for example in another layout.
    if (!offered_[placeOf(at_)]) leave();
}

bool KeyWalk::offer(KeyStop stop) {
    fresh_[placeOf(stop)] = true;
    if (wanted_ != stop) return false;
    at_ = std::exchange(wanted_, KeyStop::View);
    return true;
}

bool KeyWalk::go(int direction) {
    const int count = static_cast<int>(kKeyStopCount);
    int place = static_cast<int>(placeOf(at_));
    do {
        place = (place + direction + count) % count;
    } while (!offered_[static_cast<std::size_t>(place)]);
    wanted_ = static_cast<KeyStop>(place);
    if (wanted_ != KeyStop::View) return false;
    at_ = KeyStop::View;
    return true;
}

}  // namespace se::view
