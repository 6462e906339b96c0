#include "exact_text.h"

#include <charconv>
#include <cmath>
#include <system_error>
#include <vector>

#include "spiraling_edge/base/number_text.h"
#include "spiraling_edge/base/text_scan.h"

namespace se::view {

std::string exact(double value) {
    std::string text;
    appendNumber(text, value);
    return text;
}

std::optional<double> numberFromText(std::string_view text) {
    double value = 0.0;
    return io::parseDouble(text, value) && std::isfinite(value) ? std::optional(value)
                                                                : std::nullopt;
}

std::optional<std::uint64_t> wholeFromText(std::string_view text) {
    std::uint64_t value = 0;
    const auto read = std::from_chars(text.data(), text.data() + text.size(), value);
    const bool whole = read.ec == std::errc{} && read.ptr == text.data() + text.size();
    return whole ? std::optional(value) : std::nullopt;
}

std::string boxText(const WallBox& box, char between) {
    std::string text;
    for (const Vec3& corner : {box.low, box.high}) {
        for (int i = 0; i < 3; ++i) {
            if (!text.empty()) text += between;
            text += exact(corner[i]);
        }
    }
    return text;
}

std::optional<WallBox> boxFromText(std::string_view text, char between) {
    std::vector<double> numbers;
    while (true) {
        const std::size_t end = text.find(between);
        const auto number = numberFromText(text.substr(0, end));
        if (!number) return std::nullopt;
        numbers.push_back(*number);
        if (end == std::string_view::npos) break;
        text.remove_prefix(end + 1);
    }
    if (numbers.size() != 6) return std::nullopt;
    const WallBox box{{numbers[0], numbers[1], numbers[2]}, {numbers[3], numbers[4], numbers[5]}};
    const bool ordered = box.low.x < box.high.x && box.low.y < box.high.y && box.low.z < box.high.z;
    return ordered ? std::optional(box) : std::nullopt;
}

}  // namespace se::view
