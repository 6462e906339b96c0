/// Positions as the user types them.
#include <charconv>
#include <cmath>

#include "moves.h"
#include "run/strings.h"
#include "session.h"

namespace se::view {

namespace {

std::optional<long> readNumber(std::string_view text) {
    long value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
    return value;
}

}  // namespace

Status Moves::goToText(const std::string& given) {
    const std::string text = trimmed(given);
    const Error unknown{"\"" + text +
                        "\" is not an address. Examples: 137, 137.sphere.3, +10, 50%, p812."};
    if (!session_.ready() || text.empty()) return unknown;
    if (text.front() == '+' || text.front() == '-') {
        const auto number = readNumber(std::string_view(text).substr(text.front() == '+' ? 1 : 0));
        if (!number || std::abs(*number) > 1'000'000'000L) return unknown;
        stepPivot(static_cast<int>(*number));
        return success();
    }
    if (text.back() == '%') {
        const auto share = readNumber(std::string_view(text).substr(0, text.size() - 1));
        if (!share || *share < 0 || *share > 100) return unknown;
        goToShare(static_cast<double>(*share) / 100.0);
        return success();
    }
    if (text.front() == 'p') {
        const auto point = readNumber(std::string_view(text).substr(1));
        if (!point || *point < 0) return unknown;
        if (static_cast<std::size_t>(*point) >= session_.model().points.size()) {
            return Error{"There is no point " + std::to_string(*point) + "; the last one is " +
                         std::to_string(session_.model().points.size() - 1) + "."};
        }
        session_.select(static_cast<Index>(*point));
        goToPoint(static_cast<Index>(*point));
        return success();
    }
    const std::optional<Address> address = addressFromString(text);
    if (!address) return unknown;
    goTo(*address);
    return success();
}

}  // namespace se::view
