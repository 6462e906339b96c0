/// Lines, fields and numbers of text, shared by the readers. Nothing here depends on the
/// locale, and nothing reads past the text it was given.
#pragma once

#include <algorithm>
#include <charconv>
#include <clocale>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "spiraling_edge/base/outside_text.h"
#include "spiraling_edge/base/result.h"

namespace se::io {

/// "NAME: PLACE: WHAT", the form of every error about the content of a file.
inline Error errorAt(const std::string& name, const std::string& place, const std::string& what) {
    return Error{name + ": " + place + ": " + what};
}

/// A line number as a place: "line 12".
inline std::string lineText(std::size_t number) { return "line " + std::to_string(number); }
/// A byte as a place: "byte 84".
inline std::string byteText(std::size_t byte) { return "byte " + std::to_string(byte); }

inline bool isSpace(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f'; }

/// The content of a line before its comment, which `sign` begins; not in "1.#QNAN", the word of
/// older programs of Windows for a number that is none.
inline std::string_view beforeComment(std::string_view line, char sign) {
    std::size_t at = line.find(sign);
    while (at != std::string_view::npos && at > 0 && line[at - 1] == '.')
        at = line.find(sign, at + 1);
    return line.substr(0, at);
}

/// Iterates over the lines of a text and their numbers, counted from 1.
class LineReader {
  public:
    /// `linesBefore`: the number of lines of the file before `text`.
    explicit LineReader(std::string_view text, std::size_t linesBefore = 0)
        : rest_(text), number_(linesBefore) {}

    /// Moves to the next line, blank or not. False at the end of the text.
    bool next() {
        if (rest_.empty()) return false;
        const std::size_t length = std::min(rest_.find('\n'), rest_.size());
        line_ = rest_.substr(0, length);
        rest_.remove_prefix(std::min(length + 1, rest_.size()));
        ++number_;
        return true;
    }
    /// Moves to the next line that has more than blanks, without the rest from the character
    /// `comment` on; '\0' means that the format has no comments.
    bool nextContent(char comment = '\0') {
        while (next()) {
            if (comment != '\0') line_ = beforeComment(line_, comment);
            if (!std::all_of(line_.begin(), line_.end(), isSpace)) return true;
        }
        line_ = {};
        return false;
    }

    std::string_view line() const { return line_; }
    std::size_t number() const { return number_; }
    /// The text after the current line.
    std::string_view rest() const { return rest_; }

  private:
    std::string_view rest_;
    std::string_view line_;
    std::size_t number_;
};

/// Splits a line into fields at blanks and tabs, and at one or two more characters if given.
class Fields {
  public:
    explicit Fields(std::string_view line, char extraSeparator = ' ', char otherSeparator = ' ')
        : rest_(line), extra_(extraSeparator), other_(otherSeparator) {}

    /// The next field; empty when there is none left.
    std::string_view next() {
        std::size_t begin = 0;
        while (begin < rest_.size() && separates(rest_[begin])) ++begin;
        std::size_t end = begin;
        while (end < rest_.size() && !separates(rest_[end])) ++end;
        const std::string_view field = rest_.substr(begin, end - begin);
        rest_.remove_prefix(end);
        return field;
    }

  private:
    bool separates(char c) const { return isSpace(c) || c == extra_ || c == other_; }

    std::string_view rest_;
    char extra_;
    char other_;
};

/// The words of a text: what is between blanks, tabs, and two characters, line ends if not given.
inline std::vector<std::string> wordsIn(std::string_view text, char extraSeparator = '\n',
                                        char otherSeparator = '\n') {
    std::vector<std::string> words;
    Fields fields(text, extraSeparator, otherSeparator);
    for (std::string_view word = fields.next(); !word.empty(); word = fields.next())
        words.emplace_back(word);
    return words;
}

/// A number without its leading '+'; empty if a second sign follows.
inline std::string_view withoutPlus(std::string_view field) {
    if (field.empty() || field.front() != '+') return field;
    field.remove_prefix(1);
    const bool secondSign = !field.empty() && (field.front() == '-' || field.front() == '+');
    return secondSign ? std::string_view{} : field;
}

/// "nan", "inf" or "infinity" in any case, with or without a sign, and the words of older runtime
/// libraries of Windows: "1.#QNAN", "-1.#IND", "1.#INF", with zeros after them. False if it is none
/// of them.
inline bool parseNonFinite(std::string_view field, double& value) {
    const bool minus = !field.empty() && field.front() == '-';
    if (minus) field.remove_prefix(1);
    std::string lower;
    for (const char c : field.substr(0, 12)) lower += static_cast<char>(c | 0x20);
    if (field.starts_with("1.#")) {
        lower.erase(0, 3);
        lower.erase(std::min(lower.find('0'), lower.size()));
        if (lower == "ind" || lower == "qnan" || lower == "snan") lower = "nan";
    }
    if (lower == "nan") {
        value = std::numeric_limits<double>::quiet_NaN();
    } else if (lower == "inf" || lower == "infinity") {
        value = std::numeric_limits<double>::infinity();
    } else {
        return false;
    }
    if (minus) value = -value;
    return true;
}

/// parseDouble() for libraries that lack std::from_chars for double, and for numbers too small or
/// too large for it. strtod() follows the locale, so it is given the locale's decimal point.
inline bool parseDoubleByStrtod(std::string_view field, double& value) {
    std::string text(withoutPlus(field));
    if (text.empty()) return false;
    if (parseNonFinite(text, value)) return true;
    // strtod() would also take hexadecimal numbers and leading blanks.
    if (text.find_first_not_of("0123456789.eE+-") != std::string::npos) return false;
    const std::string point = std::localeconv()->decimal_point;
    if (const std::size_t dot = text.find('.'); dot != std::string::npos && point != ".") {
        text.replace(dot, 1, point);
    }
    char* end = nullptr;
    value = std::strtod(text.c_str(), &end);
    return end == text.c_str() + text.size();
}

/// Reads all of `field` as a decimal number; "nan" and "inf" are numbers. False if it is not one. A
/// number below the smallest double becomes 0, one beyond the largest infinite.
inline bool parseDouble(std::string_view field, double& value) {
#if defined(__cpp_lib_to_chars)
    const std::string_view digits = withoutPlus(field);
    const char* const end = digits.data() + digits.size();
    const auto [stop, problem] = std::from_chars(digits.data(), end, value);
    if (problem == std::errc{}) return stop == end || parseNonFinite(digits, value);
    if (problem != std::errc::result_out_of_range) return false;
#endif
    return parseDoubleByStrtod(field, value);
}

/// Reads all of `field` as a whole decimal number.
inline bool parseInteger(std::string_view field, std::int64_t& value) {
    const std::string_view digits = withoutPlus(field);
    const char* const end = digits.data() + digits.size();
    const auto [stop, problem] = std::from_chars(digits.data(), end, value);
    return problem == std::errc{} && stop == end;
}

}  // namespace se::io

namespace se {

/// All of `text` as one finite number; empty if it is none, or beyond the range of `Number`.
template <typename Number>
std::optional<Number> numberIn(std::string_view text) {
    Number number{};
    if constexpr (std::is_floating_point_v<Number>) {
        if (!io::parseDouble(text, number) || !std::isfinite(number)) return std::nullopt;
    } else {
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
        if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
    }
    return number;
}

/// `count` finite numbers separated by commas, blanks around them allowed; empty if the text is
/// anything else.
inline std::optional<std::vector<double>> numbersIn(std::string_view text, std::size_t count) {
    std::vector<double> numbers;
    while (true) {
        const std::size_t comma = std::min(text.find(','), text.size());
        io::Fields fields(text.substr(0, comma));
        double number = 0.0;
        const bool good = io::parseDouble(fields.next(), number) && std::isfinite(number);
        if (!good || !fields.next().empty()) return std::nullopt;
        numbers.push_back(number);
        if (comma == text.size()) break;
        text.remove_prefix(comma + 1);
    }
    return numbers.size() == count ? std::optional(numbers) : std::nullopt;
}

}  // namespace se
