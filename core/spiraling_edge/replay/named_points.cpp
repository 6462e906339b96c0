#include "spiraling_edge/replay/named_points.h"

#include <algorithm>
#include <array>
#include <charconv>

namespace se {

namespace {

/// Prefixes of the number of a point, or several: "edge=812,640", "among=3..9".
constexpr std::array<std::string_view, 8> kNaming = {
    "point=", "pivot=", "used=", "done=", "stranded=", "edge=", "among=", "status="};

constexpr std::string_view kDigits = "0123456789";

bool namesPoints(std::string_view word) {
    return std::any_of(kNaming.begin(), kNaming.end(),
                       [&](std::string_view each) { return word.starts_with(each); });
}

/// The first number in `word` that is not below `points`; empty if there is none.
std::string_view beyond(std::string_view word, std::size_t points) {
    while (true) {
        word.remove_prefix(std::min(word.find_first_of(kDigits), word.size()));
        if (word.empty()) return {};
        const std::string_view digits = word.substr(0, word.find_first_not_of(kDigits));
        std::size_t number = 0;
        const auto read = std::from_chars(digits.data(), digits.data() + digits.size(), number);
        if (read.ec != std::errc() || number >= points) return digits;
        word.remove_prefix(digits.size());
    }
}

}  // namespace

std::string missingPointIn(std::string_view line, std::size_t points) {
    while (!line.empty()) {
        line.remove_prefix(std::min(line.find_first_not_of(" \t"), line.size()));
        const std::string_view word = line.substr(0, line.find_first_of(" \t"));
        line.remove_prefix(word.size());
        if (!namesPoints(word)) continue;
        const std::string_view number = beyond(word, points);
        if (number.empty()) continue;
        return "There is no point " + std::string(number) +
               (points == 0 ? ": there are no points."
                            : ": the points are 0 to " + std::to_string(points - 1) + ".");
    }
    return {};
}

}  // namespace se
