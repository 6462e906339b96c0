/// Numbers as text that reads back exactly.
#pragma once

#include <array>
#include <charconv>
#include <cstdio>
#include <cstdlib>
#include <string>

namespace se {

/// Appends the shortest decimal number that reads back as `value`.
inline void appendNumber(std::string& text, double value) {
    std::array<char, 40> out;
#if defined(__cpp_lib_to_chars)
    const auto end = std::to_chars(out.data(), out.data() + out.size(), value).ptr;
    text.append(out.data(), end);
#else
    constexpr int kDigits = 17;  // Enough for any double.
    int length = 0;
    for (int digits = kDigits - 2; digits <= kDigits; ++digits) {
        length = std::snprintf(out.data(), out.size(), "%.*g", digits, value);
        if (std::strtod(out.data(), nullptr) == value) break;
    }
    text.append(out.data(), static_cast<std::size_t>(length));
#endif
}

}  // namespace se
