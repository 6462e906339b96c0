/// Numbers as text: exact, or rounded for display.
#pragma once

#include <array>
#include <charconv>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>
#include <system_error>

#include "spiraling_edge/base/types.h"

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

/// The number as by appendNumber(), but without an exponent where that takes 17 characters at most:
/// "500000", not "5e+05".
inline std::string plainNumber(double value) {
#if defined(__cpp_lib_to_chars)
    std::array<char, 17> out;
    const auto [end, problem] =
        std::to_chars(out.data(), out.data() + out.size(), value, std::chars_format::fixed);
    if (problem == std::errc{}) return {out.data(), end};
#endif
    std::string text;
    appendNumber(text, value);
    return text;
}

/// The three numbers as plainNumber() writes them: "500000,5400000,0.5".
inline std::string plainNumbers(const Vec3& v, std::string_view separator = ",") {
    std::string text;
    for (int i = 0; i < 3; ++i) {
        if (i > 0) text += separator;
        text += plainNumber(v[i]);
    }
    return text;
}

/// `value` with six significant digits; the same on every machine.
inline std::string sixDigits(double value) {
    std::array<char, 32> out;
    std::snprintf(out.data(), out.size(), "%.6g", value == 0.0 ? 0.0 : value);
    return out.data();
}

/// `value` with three significant digits; the same on every machine.
inline std::string shortNumber(double value) {
    std::array<char, 32> out;
    std::snprintf(out.data(), out.size(), "%.3g", value == 0.0 ? 0.0 : value);
    return out.data();
}

}  // namespace se
