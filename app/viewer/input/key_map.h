/// Which keys stand for which command: those of the table, except where a person chose others.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "keys.h"

namespace se::view {

struct Command;

class KeyMap {
  public:
    /// Command id to its keys, "F10 ."; empty: none.
    using Changes = std::map<std::string, std::string, std::less<>>;

    /// The keys of a command, apart by blanks.
    std::string keysOf(const Command& command) const;
    /// The first of them, for menus; empty if there is none.
    std::string first(const Command& command) const;
    /// All of them, joined by ", ".
    std::string all(const Command& command) const;
    /// The command of a key, null if it has none.
    const Command* commandFor(const KeyChord& chord) const;

    /// Makes `chord` the only key of a command, and takes it from the one that had it.
    void bind(const Command& command, const KeyChord& chord);
    /// Leaves a command without a key.
    void unbind(const Command& command);
    /// The keys of the table again; they are taken from those that have them now.
    void reset(const Command& command);
    void resetAll() { changes_.clear(); }
    bool isChanged(const Command& command) const;

    const Changes& changes() const { return changes_; }
    /// Takes over what the settings say. Returns one sentence for each thing that cannot be so:
    /// no such command, no such key, a key for two commands. All else holds.
    std::vector<std::string> load(const Changes& wanted);

    friend bool operator==(const KeyMap&, const KeyMap&) = default;

  private:
    void assign(const Command& command, const std::string& keys);
    void takeAway(const KeyChord& chord);

    Changes changes_;  ///< Only what differs from the table.
};

/// Asking a person for a new key of a command.
class KeyCapture {
  public:
    bool active() const { return !command_.empty(); }
    /// The id of the command that is asked about; empty if none is.
    const std::string& command() const { return command_; }
    /// What there is to say: a conflict, a key that cannot be, what was done.
    const std::string& note() const { return note_; }
    void begin(std::string_view command);
    void cancel() { *this = {}; }
    /// Esc ends it, Backspace leaves the command without a key. A key that another command has is
    /// named with it; pressed once more, it changes hands.
    void press(const KeyChord& chord, KeyMap& map);

  private:
    std::string command_;
    std::string note_;
    KeyChord conflict_;
};

}  // namespace se::view
