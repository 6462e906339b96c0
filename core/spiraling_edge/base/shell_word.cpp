#include "spiraling_edge/base/shell_word.h"

#include "spiraling_edge/base/outside_text.h"

namespace se {
namespace {

bool isPlain(char c) {
    constexpr std::string_view kPlain =
        "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_./:+-@%,";
    return kPlain.find(c) != std::string_view::npos;
}

/// A sign of the format of printf.
std::string formatSign(char c, bool isFirst) {
    if (isPlain(c) && c != '%' && !(c == '-' && isFirst)) return {c};
    const auto byte = static_cast<unsigned char>(c);
    const auto digit = [byte](unsigned shift) {
        return static_cast<char>('0' + (byte >> shift & 7U));
    };
    return {'\\', digit(6), digit(3), digit(0)};
}

/// "$(printf 'a\012b')": single quotes would have to hold the bytes themselves, and $'...' is not
/// known to every shell.
std::string printedWord(std::string_view word) {
    const std::size_t end = word.find_last_not_of('\n') + 1;
    std::string text = "\"$(printf '";
    for (std::size_t i = 0; i < end; ++i) text += formatSign(word[i], i == 0);
    text += "')";
    // Newlines at the end are not substituted; IFS is a blank, a tab and a newline.
    for (std::size_t i = end; i < word.size(); ++i) text += "${IFS#??}";
    return text + "\"";
}

}  // namespace

std::string shellQuoted(std::string_view word) {
    bool plain = !word.empty();
    for (const char c : word) plain = plain && isPlain(c);
    if (plain) return std::string(word);
    if (printable(word) != word) return printedWord(word);
    std::string quoted = "'";
    for (const char c : word) quoted += c == '\'' ? "'\\''" : std::string(1, c);
    return quoted + "'";
}

std::string shellPath(std::string_view path) {
    const bool isOption = path.starts_with('-') && path != "-";
    return shellQuoted((isOption ? "./" : "") + std::string(path));
}

}  // namespace se
