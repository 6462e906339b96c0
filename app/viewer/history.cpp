#include "history.h"

#include <utility>

namespace se::view {

void History::leave(std::string place) {
    after_.clear();
    if (!before_.empty() && before_.back() == place) return;
    before_.push_back(std::move(place));
    if (before_.size() > kMost) before_.erase(before_.begin());
}

std::optional<std::string> History::back(std::string here) {
    if (before_.empty()) return std::nullopt;
    std::string place = std::move(before_.back());
    before_.pop_back();
    after_.push_back(std::move(here));
    return place;
}

std::optional<std::string> History::forward(std::string here) {
    if (after_.empty()) return std::nullopt;
    std::string place = std::move(after_.back());
    after_.pop_back();
    before_.push_back(std::move(here));
    return place;
}

}  // namespace se::view
