#include "spiraling_edge/base/outside_text.h"

#include <algorithm>
#include <array>
#include <cstdint>

namespace se {
namespace {

constexpr std::string_view kHexDigits = "0123456789abcdef";

/// A character, or a byte that is none.
struct Sign {
    std::string_view bytes;
    std::uint32_t code = 0xfffd;  ///< The replacement character if the byte is no UTF-8.
};

Sign firstSign(std::string_view text) {
    const std::size_t length = utf8Length(text);
    if (length == 0) return {text.substr(0, 1)};
    // The first byte of several has as many leading ones as there are bytes.
    const auto first = static_cast<unsigned char>(text.front());
    std::uint32_t code = length == 1 ? first : first & (0x7fU >> length);
    for (std::size_t i = 1; i < length; ++i)
        code = code << 6U | (static_cast<unsigned char>(text[i]) & 0x3fU);
    return {text.substr(0, length), code};
}

struct CodeRange {
    std::uint32_t first;
    std::uint32_t last;
};

/// Control characters, and marks that end a line or change the direction of writing.
constexpr std::array kUnfit{CodeRange{0, 0x1f},        CodeRange{0x7f, 0x9f},
                            CodeRange{0x61c, 0x61c},   CodeRange{0x200e, 0x200f},
                            CodeRange{0x2028, 0x202e}, CodeRange{0x2066, 0x2069}};

bool isFit(const Sign& sign) {
    if (utf8Length(sign.bytes) == 0) return false;
    return std::none_of(kUnfit.begin(), kUnfit.end(), [&](const CodeRange& range) {
        return sign.code >= range.first && sign.code <= range.last;
    });
}

std::string escapedBytes(const Sign& sign) {
    if (sign.bytes == "\n") return "\\n";
    if (sign.bytes == "\t") return "\\t";
    std::string text;
    for (const char c : sign.bytes) {
        const auto byte = static_cast<unsigned char>(c);
        text.append({'\\', 'x', kHexDigits[byte / 16U], kHexDigits[byte % 16U]});
    }
    return text;
}

std::string escapedCode(const Sign& sign) {
    std::string text = "\\u";
    for (const unsigned shift : {12U, 8U, 4U, 0U}) text += kHexDigits[sign.code >> shift & 0xfU];
    return text;
}

/// `text` with each unfit sign, except `kept`, replaced by `escape` of it.
template <typename Escape>
std::string replaced(std::string_view text, std::string_view kept, const Escape& escape) {
    std::string out;
    out.reserve(text.size());
    while (!text.empty()) {
        const Sign sign = firstSign(text);
        out += isFit(sign) || sign.bytes == kept ? std::string(sign.bytes) : escape(sign);
        text.remove_prefix(sign.bytes.size());
    }
    return out;
}

}  // namespace

std::size_t utf8Length(std::string_view text) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const unsigned first = byte(0);
    if (first < 0x80) return 1;
    const std::size_t length = first >= 0xf0 ? 4 : first >= 0xe0 ? 3 : 2;
    if (first < 0xc2 || first > 0xf4 || text.size() < length) return 0;
    for (std::size_t i = 1; i < length; ++i) {
        if ((byte(i) & 0xc0U) != 0x80U) return 0;
    }
    // Longer than needed, a surrogate, or beyond the last character.
    const unsigned second = byte(1);
    const bool wrong = (first == 0xe0 && second < 0xa0) || (first == 0xed && second > 0x9f) ||
                       (first == 0xf0 && second < 0x90) || (first == 0xf4 && second > 0x8f);
    return wrong ? 0 : length;
}

std::string printable(std::string_view text) { return replaced(text, {}, escapedBytes); }

std::string printableLines(std::string_view text) { return replaced(text, "\n", escapedBytes); }

std::string printableJson(std::string_view json) { return replaced(json, "\n", escapedCode); }

std::string excerpt(std::string_view text) {
    constexpr std::size_t kLongest = 80;
    std::string out;
    std::size_t characters = 0;
    while (!text.empty()) {
        const Sign sign = firstSign(text);
        const std::string piece = printable(sign.bytes);
        characters += isFit(sign) ? 1 : piece.size();
        if (characters > kLongest) return out + "...";
        out += piece;
        text.remove_prefix(sign.bytes.size());
    }
    return out;
}

std::string inQuotes(std::string_view field) { return "\"" + excerpt(field) + "\""; }

}  // namespace se
