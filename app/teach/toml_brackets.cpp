#include "toml_brackets.h"

#include <algorithm>
#include <string>

namespace se::teach {
namespace {

/// Length of the string at the start of `text`, with its quotes. One that is not closed ends with
/// its line, or with the text: toml++ refuses it there.
std::size_t stringLength(std::string_view text) {
    const char quote = text.front();
    const std::string longQuote(3, quote);
    const bool isLong = text.starts_with(longQuote);
    const std::string_view close = isLong ? std::string_view(longQuote) : text.substr(0, 1);
    for (std::size_t i = close.size(); i < text.size(); ++i) {
        if (quote == '"' && text[i] == '\\') {
            ++i;
        } else if (text.substr(i).starts_with(close)) {
            return i + close.size();
        } else if (!isLong && text[i] == '\n') {
            return i;
        }
    }
    return text.size();
}

/// Length of what stands at the start of `text`: a string, a comment or one character.
std::size_t tokenLength(std::string_view text) {
    if (text.front() == '"' || text.front() == '\'') return stringLength(text);
    return text.front() == '#' ? std::min(text.find('\n'), text.size()) : 1;
}

}  // namespace

StraySign strayTomlSign(std::string_view toml) {
    constexpr std::string_view kBracket =
        "a bracket that does not belong there; a table is written as { ... }";
    constexpr std::string_view kLetter =
        "a letter or sign that does not belong there; texts stand in \"quotation marks\"";
    std::string open;
    std::size_t line = 1;
    bool startsLine = true;
    while (!toml.empty()) {
        const std::size_t length = tokenLength(toml);
        const std::string_view token = toml.substr(0, length);
        if (static_cast<unsigned char>(token.front()) > 0x7F) return {line, kLetter};
        if (token == "[" && startsLine && open.empty()) return {line, kBracket};
        if (token == "[") open += ']';
        if (token == "{") open += '}';
        if (token == "]" || token == "}") {
            if (open.empty() || open.back() != token.front()) return {line, kBracket};
            open.pop_back();
        }
        line += static_cast<std::size_t>(std::count(token.begin(), token.end(), '\n'));
        startsLine = token == "\n" || (startsLine && (token == " " || token == "\t"));
        toml.remove_prefix(length);
    }
    return {};
}

}  // namespace se::teach
