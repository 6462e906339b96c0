#include "key_map.h"

#include <array>
#include <set>

#include "spiraling_edge/base/text_scan.h"
#include "spiraling_edge/base/word_list.h"

namespace se::view {

namespace {

struct NamedKey {
    std::string_view name;
    int key;
};

constexpr std::array<NamedKey, 16> kNamedKeys = {{{"Space", key::kSpace},
                                                  {"Esc", key::kEscape},
                                                  {"Enter", key::kEnter},
                                                  {"Right", key::kRight},
                                                  {"Left", key::kLeft},
                                                  {"Down", key::kDown},
                                                  {"Up", key::kUp},
                                                  {"Home", key::kHome},
                                                  {"End", key::kEnd},
                                                  {"Plus", '+'},
                                                  {"Tab", key::kTab},
                                                  {"Backspace", key::kBackspace},
                                                  {"Insert", key::kInsert},
                                                  {"Delete", key::kDelete},
                                                  {"PageUp", key::kPageUp},
                                                  {"PageDown", key::kPageDown}}};

struct NamedMod {
    std::string_view name;
    int mod;
};

constexpr std::array<NamedMod, 3> kMods = {{{"Ctrl+", kCtrl}, {"Alt+", kAlt}, {"Shift+", kShift}}};

int keyNumber(std::string_view text) {
    for (const NamedKey& named : kNamedKeys) {
        if (named.name == text) return named.key;
    }
    if (text.size() > 1 && text.front() == 'F') {
        const int number = numberIn<int>(text.substr(1)).value_or(0);
        return number >= 1 && number <= 24 ? key::kF1 + number - 1 : 0;
    }
    return text.size() == 1 ? static_cast<unsigned char>(text.front()) : 0;
}

}  // namespace

std::optional<KeyChord> keyFromString(std::string_view text) {
    KeyChord chord;
    for (bool found = true; found;) {
        found = false;
        for (const NamedMod& each : kMods) {
            if (!text.starts_with(each.name)) continue;
            chord.mods |= each.mod;
            text.remove_prefix(each.name.size());
            found = true;
        }
    }
    chord.key = keyNumber(text);
    if (chord.key == 0) return std::nullopt;
    return chord;
}

std::string toString(const KeyChord& chord) {
    std::string text;
    for (const NamedMod& each : kMods) {
        if ((chord.mods & each.mod) != 0) text += each.name;
    }
    for (const NamedKey& named : kNamedKeys) {
        if (named.key == chord.key) return text + std::string(named.name);
    }
    if (chord.isFunctionKey()) return text + "F" + std::to_string(chord.key - key::kF1 + 1);
    // A key without a character and without a name here has no text either.
    const bool sign = chord.key > ' ' && chord.key < 127;
    return sign ? text + static_cast<char>(chord.key) : std::string{};
}

std::string KeyMap::keysOf(const Command& command) const {
    const auto changed = changes_.find(command.id);
    return changed != changes_.end() ? changed->second : std::string(command.keys);
}

std::string KeyMap::first(const Command& command) const {
    const auto words = io::wordsIn(keysOf(command));
    return words.empty() ? std::string{} : words.front();
}

std::string KeyMap::all(const Command& command) const {
    return joined(io::wordsIn(keysOf(command)), ", ");
}

const Command* presenterCommandFor(const KeyChord& chord) {
    for (const Command& command : commands()) {
        for (const std::string& word : io::wordsIn(std::string(command.presenterKeys))) {
            if (keyFromString(word) == chord) return &command;
        }
    }
    return nullptr;
}

const Command* KeyMap::commandFor(const KeyChord& chord) const {
    for (const Command& command : commands()) {
        for (const std::string& word : io::wordsIn(keysOf(command))) {
            if (keyFromString(word) == chord) return &command;
        }
    }
    return nullptr;
}

void KeyMap::assign(const Command& command, const std::string& keys) {
    if (keys == command.keys) {
        changes_.erase(std::string(command.id));
    } else {
        changes_[std::string(command.id)] = keys;
    }
}

void KeyMap::takeAway(const KeyChord& chord) {
    const Command* owner = commandFor(chord);
    if (owner == nullptr) return;
    std::vector<std::string> rest = io::wordsIn(keysOf(*owner));
    std::erase_if(rest, [&](const std::string& word) { return keyFromString(word) == chord; });
    assign(*owner, joined(rest, " "));
}

void KeyMap::bind(const Command& command, const KeyChord& chord) {
    takeAway(chord);
    assign(command, toString(chord));
}

void KeyMap::unbind(const Command& command) { assign(command, ""); }

void KeyMap::reset(const Command& command) {
    for (const std::string& word : io::wordsIn(command.keys)) takeAway(*keyFromString(word));
    assign(command, std::string(command.keys));
}

bool KeyMap::isChanged(const Command& command) const { return changes_.contains(command.id); }

std::vector<std::string> KeyMap::load(const Changes& wanted) {
    changes_.clear();
    std::vector<std::string> complaints;
    std::set<std::string> taken;  // keys assigned by the settings themselves
    for (const auto& [id, keys] : wanted) {
        const Command* command = findCommand(id);
        if (command == nullptr) {
            complaints.push_back("Keys: there is no action " + id + ".");
            continue;
        }
        std::vector<std::string> good;
        const auto refused = [&complaints, &which = id](const std::string& word, const char* why) {
            complaints.push_back(std::string("Keys: ").append(word).append(" (for ").append(which) +
                                 why);
        };
        for (const std::string& word : io::wordsIn(keys)) {
            const auto chord = keyFromString(word);
            if (!chord) {
                refused(word, ") is not a key.");
            } else if (!taken.insert(toString(*chord)).second) {
                refused(word, ") is assigned to another action.");
            } else {
                takeAway(*chord);
                good.push_back(toString(*chord));
            }
        }
        assign(*command, joined(good, " "));
    }
    return complaints;
}

void KeyCapture::begin(std::string_view command) {
    *this = {};
    command_ = command;
    note_ = "Press the new key. Esc: cancel; Backspace: no key.";
}

void KeyCapture::press(const KeyChord& chord, KeyMap& map) {
    const Command* command = findCommand(command_);
    if (isModifierKey(chord.key) || command == nullptr) return;
    if (chord.key == key::kEscape) return cancel();
    const bool none = chord.key == key::kBackspace && chord.mods == 0;
    const std::string name = toString(chord);
    if (!none && keyFromString(name) != chord) {
        note_ = "This key has no name and cannot be used. Press another one, or Esc.";
        return;
    }
    const Command* owner = none ? nullptr : map.commandFor(chord);
    if (owner != nullptr && owner != command && chord != conflict_) {
        conflict_ = chord;
        note_ = name + " is the key of \"" + std::string(owner->title) +
                "\". Press it again to reassign it, or press another one.";
        return;
    }
    none ? map.unbind(*command) : map.bind(*command, chord);
    const std::string title(command->title);
    cancel();
    note_ = title + ": " + (none ? "no key" : name) + ".";
}

}  // namespace se::view
