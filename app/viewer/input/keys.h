/// Keys as values: read from and written as "Ctrl+Shift+F5".
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace se::view {

/// Modifier bits and key numbers equal those of GLFW; window.cpp checks that.
enum KeyMods : int { kNoMods = 0, kShift = 1, kCtrl = 2, kAlt = 4 };

namespace key {
inline constexpr int kSpace = 32;
inline constexpr int kEscape = 256;
inline constexpr int kEnter = 257;
inline constexpr int kTab = 258;
inline constexpr int kBackspace = 259;
inline constexpr int kInsert = 260;
inline constexpr int kDelete = 261;
inline constexpr int kRight = 262;
inline constexpr int kLeft = 263;
inline constexpr int kDown = 264;
inline constexpr int kUp = 265;
inline constexpr int kPageUp = 266;
inline constexpr int kPageDown = 267;
inline constexpr int kHome = 268;
inline constexpr int kEnd = 269;
inline constexpr int kF1 = 290;
inline constexpr int kKeypadEnter = 335;
inline constexpr int kFirstModifier = 340;
inline constexpr int kLastModifier = 347;
}  // namespace key
/// Shift, Ctrl, Alt and Super, left and right.
inline bool isModifierKey(int key) {
    return key >= key::kFirstModifier && key <= key::kLastModifier;
}

struct KeyChord {
    int key = 0;  ///< Upper case letter, digit, other character or one of key::; 0: none.
    int mods = 0;
    friend bool operator==(const KeyChord&, const KeyChord&) = default;

    bool isFunctionKey() const { return key >= key::kF1 && key < key::kF1 + 24; }
};

/// "Ctrl+G", "F10", "Space", "."; empty if the text names no key.
std::optional<KeyChord> keyFromString(std::string_view text);
/// Empty for a key that has no name here.
std::string toString(const KeyChord& chord);

}  // namespace se::view
