/// Cutting texts to a width.
#pragma once

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace se::view {

/// A byte of a UTF-8 character that is not its first.
inline bool continuesSign(char byte) { return (static_cast<unsigned char>(byte) & 0xC0U) == 0x80U; }

/// A UTF-8 text without its last character, which may have several bytes.
inline std::string withoutLastSign(std::string text) {
    while (!text.empty() && continuesSign(text.back())) text.pop_back();
    if (!text.empty()) text.pop_back();
    return text;
}

/// A name that is at most `width` wide: without its middle, where dots stand for it, since names
/// differ at both ends. Only whole characters stay.
template <typename Measure>
std::string withoutMiddle(const std::string& name, float width, const Measure& measure) {
    if (measure(name) <= width) return name;
    const auto within = [&](std::size_t at) { return at < name.size() && continuesSign(name[at]); };
    std::size_t head = name.size() / 2;
    while (within(head)) ++head;
    std::size_t tail = head;
    const auto cut = [&] { return name.substr(0, head) + "\xE2\x80\xA6" + name.substr(tail); };
    while (measure(cut()) > width && (head > 0 || tail < name.size())) {
        if (head > name.size() - tail) {
            while (within(--head)) {
            }
        } else {
            while (within(++tail)) {
            }
        }
    }
    return cut();
}

/// The longest beginning of a text that is at most `width` wide; at least one character.
template <typename Measure>
std::string fittingBeginning(const std::string& text, float width, const Measure& measure) {
    std::string cut = text;
    while (measure(cut) > width) {
        std::string shorter = withoutLastSign(cut);
        if (shorter.empty()) break;
        cut = std::move(shorter);
    }
    return cut;
}

/// Lines of at most `width`, as measured by `measure(const std::string&)`: broken at line ends and
/// spaces, never inside of a number. Only a word wider than a whole line is cut, such as a path.
/// At least one line.
template <typename Measure>
std::vector<std::string> linesAtBlanks(std::string_view text, float width, const Measure& measure) {
    std::vector<std::string> lines(1);
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = std::min(text.find_first_of(" \n", at), text.size());
        const std::string word(text.substr(at, end - at));
        std::string longer = lines.back().empty() ? word : lines.back() + " " + word;
        if (lines.back().empty() || measure(longer) <= width) {
            lines.back() = std::move(longer);
        } else {
            lines.push_back(word);
        }
        while (measure(lines.back()) > width) {
            std::string head = fittingBeginning(lines.back(), width, measure);
            std::string rest = lines.back().substr(head.size());
            if (rest.empty()) break;
            lines.back() = std::move(head);
            lines.push_back(std::move(rest));
        }
        if (end < text.size() && text[end] == '\n') lines.emplace_back();
        at = end + 1;
    }
    return lines;
}

}  // namespace se::view
