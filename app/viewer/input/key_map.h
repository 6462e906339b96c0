/// A row of the table of commands, which stands in commands/, and the keys of commands: those of
/// the table, except where the user chose others.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace se::view {

// Keys as values: read from and written as "Ctrl+Shift+F5".

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

struct CommandContext;

struct Command {
    std::string_view id;     ///< "step.pivot.next": menu path and stable name.
    std::string_view group;  ///< Menu and section of the cheat sheet.
    std::string_view title;
    std::string_view keys;  ///< "F10 .": one or more, separated by spaces; may be empty.
    std::string_view help;  ///< One sentence.
    void (*run)(CommandContext& context);
    /// Synonyms for the search of the palette, separated by spaces.
    std::string_view synonyms = {};
    bool repeats = false;  ///< Also while the key is held down.
    /// Keys in the layout Present alone, where they come before all others: those that the remote
    /// control of a presenter sends.
    std::string_view presenterKeys = {};
};

std::span<const Command> commands();
const Command* findCommand(std::string_view id);

/// The command that a key has in the layout Present; null if it is that of the other layouts.
const Command* presenterCommandFor(const KeyChord& chord);

class KeyMap {
  public:
    /// Command id to its keys, "F10 ."; empty: none.
    using Changes = std::map<std::string, std::string, std::less<>>;

    /// The keys of a command, separated by spaces.
    std::string keysOf(const Command& command) const;
    /// The first of them, for menus; empty if there is none.
    std::string first(const Command& command) const;
    /// All of them, joined by ", ".
    std::string all(const Command& command) const;
    /// The command of a key, null if it has none.
    const Command* commandFor(const KeyChord& chord) const;

    /// Makes `chord` the only key of a command, and removes it from the one that had it.
    void bind(const Command& command, const KeyChord& chord);
    /// Leaves a command without a key.
    void unbind(const Command& command);
    /// Restores the keys of the table; they are removed from the commands that have them now.
    void reset(const Command& command);
    void resetAll() { changes_.clear(); }
    bool isChanged(const Command& command) const;

    const Changes& changes() const { return changes_; }
    /// Loads the keys of the settings. Returns one sentence for each refused entry:
    /// no such command, no such key, a key for two commands. All other entries are used.
    std::vector<std::string> load(const Changes& wanted);

    friend bool operator==(const KeyMap&, const KeyMap&) = default;

  private:
    void assign(const Command& command, const std::string& keys);
    void takeAway(const KeyChord& chord);

    Changes changes_;  ///< Only the differences from the table.
};

/// Capture of a new key for a command.
class KeyCapture {
  public:
    bool active() const { return !command_.empty(); }
    /// The id of the command that gets the key; empty if none.
    const std::string& command() const { return command_; }
    /// Message to show: a conflict, an unusable key, the result.
    const std::string& note() const { return note_; }
    void begin(std::string_view command);
    void cancel() { *this = {}; }
    /// Esc cancels, Backspace leaves the command without a key. A key of another command is
    /// reported with its owner; pressed a second time, it is reassigned.
    void press(const KeyChord& chord, KeyMap& map);

  private:
    std::string command_;
    std::string note_;
    KeyChord conflict_;
};

}  // namespace se::view
