#include "strings.h"

#include <cstdio>
#include <utility>

#include "spiraling_edge/base/files.h"
#include "spiraling_edge/base/outside_text.h"

namespace se::view {

std::string lowerCase(std::string_view text) {
    std::string lower(text);
    for (char& c : lower) {
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    }
    return lower;
}

std::string trimmed(std::string_view text) {
    const std::size_t from = text.find_first_not_of(" \t");
    if (from == std::string_view::npos) return {};
    return std::string(text.substr(from, text.find_last_not_of(" \t") - from + 1));
}

std::string formatted(const char* format, double a, double b, double c) {
    char out[120];
    std::snprintf(out, sizeof out, format, a, b, c);
    return out;
}

std::string grouped(std::size_t number) {
    std::string text = std::to_string(number);
    for (std::size_t i = text.size(); i > 3; i -= 3) text.insert(i - 3, "\xE2\x80\x89");
    return text;
}

void printLines(std::FILE* stream, std::string_view text) {
    std::fputs(printableLines(text).c_str(), stream);
}

std::optional<std::string> readText(const std::filesystem::path& path) {
    Result<std::string> bytes = readBytes(path, kTextLimit);
    return bytes ? std::optional(std::move(bytes.value())) : std::nullopt;
}

}  // namespace se::view
