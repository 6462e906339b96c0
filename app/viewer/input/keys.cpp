#include "keys.h"

#include <array>

#include "spiraling_edge/base/text_scan.h"

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

}  // namespace se::view
