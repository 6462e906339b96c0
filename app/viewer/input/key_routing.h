/// The receiver of a key: a text field, a dialog, a panel or an action; and the delivery of keys to
/// a user interface that polls only once per frame. Plain values.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "key_map.h"

namespace se::view {

/// A key or a typed character, as reported by the window.
struct KeyPress {
    KeyChord chord;  ///< Of a character: of the key that typed it, if known.
    bool repeated = false;
    unsigned sign = 0;  ///< 0: a key.
    bool released = false;
    int rawKey = 0;  ///< By its position on the keyboard, not by its label.
    int scancode = 0;
    int rawMods = 0;
};

/// Number of waiting presses that go into the next frame; the order stays. A user interface that
/// polls keys once per frame sees nothing of Ctrl down, V down, Ctrl up, V up, and only one
/// of two keys. So a frame has at most one polled key; its release, later
/// modifiers and later characters wait for the next frame.
std::size_t pressesOfNextFrame(std::span<const KeyPress> waiting);

/// True for the character that comes with the key press just before it: it is discarded once that
/// press has run an action. Requires i < presses.size().
bool isSignOfKeyBefore(std::span<const KeyPress> presses, std::size_t i);

/// True if the character is text, not the effect of Ctrl or Alt. AltGr is both in some systems.
bool isText(const KeyPress& typed);

/// The chord that a typed character stands for where the layout has it elsewhere than the key says:
/// on a French keyboard Shift and the key of & type 1. Empty for letters, which keys are named by,
/// and where the key itself has that chord. Requires a sign.
std::optional<KeyChord> chordOfSign(const KeyPress& typed);

/// Owner of the keyboard.
struct Keyboard {
    bool textField = false;  ///< A text field.
    bool dialog = false;     ///< A window above the view.
    bool panel = false;      ///< A panel with keyboard navigation.
};

/// True for either Shift key by itself.
bool isShiftKey(int key);
/// True for keys that edit a text or move in it: plain keys, Ctrl+C and the like.
bool editsText(const KeyChord& chord);
/// True if a key may run an action. Esc always may.
bool reachesActions(const KeyChord& chord, const Keyboard& keyboard);

/// Text fields that actions open; those of dialogs take the keyboard focus by themselves.
enum class TypedField : std::uint8_t { None, Dialog, Query, Ledger, Prepare, GoTo };

/// Delay of keys until a text field opened by a command has the keyboard focus: Dear ImGui assigns
/// it some frames later.
class TypingWait {
  public:
    /// A field is opened: it gets the keyboard focus, and keys wait for it.
    void open(TypedField field) {
        opened_ = field;
        frames_ = kMaxFrames;
        takes_ = false;
    }
    /// The field that was opened and has not been drawn since.
    TypedField opened() const { return opened_; }
    /// The field is drawn. True if it is to get the keyboard focus now.
    bool takeFocus(TypedField field) {
        if (opened_ != field) return false;
        opened_ = TypedField::None;
        return true;
    }
    /// The opened field is drawn and accepts input.
    void takesKeys() { takes_ = true; }
    /// At the end of a frame. `routed`: plain keys go to a text field and to no action.
    void endFrame(bool routed) {
        frames_ = takes_ && routed ? 0 : std::max(0, frames_ - 1);
        takes_ = false;
    }
    bool waits() const { return frames_ > 0; }

  private:
    /// Dear ImGui needs about four, another layout one more. A field that never appears, for
    /// example because nothing is open, must not block the keys.
    static constexpr int kMaxFrames = 10;

    TypedField opened_ = TypedField::None;
    int frames_ = 0;
    bool takes_ = false;
};

// Keyboard focus of the panels: the current owner, and the next one for Tab. Plain values, no
// ImGui.

/// In the order of Tab. The view has the keyboard where no panel has; files and scenes are on
/// the start page, which replaces it.
enum class KeyStop : std::uint8_t { View, Rail, Content, Steps, Rings, RingPoints, Files, Scenes };
inline constexpr std::size_t kKeyStopCount = 8;

class KeyWalk {
  public:
    /// At the beginning of a frame, before panels are drawn.
    void begin();
    /// A panel is drawn and has rows to choose from. True if it gets the keyboard now.
    bool offer(KeyStop stop);
    /// To the next (+1) or previous (-1) of the panels drawn lately, the view among them; true if
    /// that is the view.
    bool go(int direction);
    /// Back to the view, without a request by go().
    void leave() { at_ = wanted_ = KeyStop::View; }
    KeyStop at() const { return at_; }

  private:
    using Offers = std::array<bool, kKeyStopCount>;
    Offers offered_{true};  ///< Panels of the previous frame.
    Offers fresh_{true};
    KeyStop at_ = KeyStop::View;
    KeyStop wanted_ = KeyStop::View;  ///< Gets the keyboard as soon as it is drawn.
};

}  // namespace se::view
