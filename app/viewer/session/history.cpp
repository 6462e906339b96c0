#include "history.h"

#include <utility>

namespace se::view {

void History::leave(std::string place) {
    after_.clear();
    if (!before_.empty() && before_.back() == place) return;
    before_.push_back(std::move(place));
    if (before_.size() > kMax) before_.erase(before_.begin());
}

namespace {

/// Moves the nearest position of `from` out, and `here` onto `to`.
std::optional<std::string> step(std::vector<std::string>& from, std::vector<std::string>& to,
                                std::string here) {
    if (from.empty()) return std::nullopt;
    std::string place = std::move(from.back());
    from.pop_back();
    to.push_back(std::move(here));
    return place;
}

}  // namespace

std::optional<std::string> History::back(std::string here) {
    return step(before_, after_, std::move(here));
}

std::optional<std::string> History::forward(std::string here) {
    return step(after_, before_, std::move(here));
}

}  // namespace se::view
