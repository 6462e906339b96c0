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

std::size_t lineOfStrayBracket(std::string_view toml) {
    std::string open;
    std::size_t line = 1;
    bool startsLine = true;
    while (!toml.empty()) {
        const std::size_t length = tokenLength(toml);
        const std::string_view token = toml.substr(0, length);
        if (token == "[" && startsLine && open.empty()) return line;
        if (token == "[") open += ']';
        if (token == "{") open += '}';
        if (token == "]" || token == "}") {
            if (open.empty() || open.back() != token.front()) return line;
            open.pop_back();
        }
        line += static_cast<std::size_t>(std::count(token.begin(), token.end(), '\n'));
        startsLine = token == "\n" || (startsLine && (token == " " || token == "\t"));
        toml.remove_prefix(length);
    }
    return 0;
}

}  // namespace se::teach
