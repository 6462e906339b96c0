#include "spiraling_edge/stepper/event.h"

#include <algorithm>
#include <charconv>

namespace se {
namespace {

std::optional<std::uint32_t> numberFrom(std::string_view text) {
    std::uint32_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
    return value;
}

/// Removes the part before the first dot from `text` and returns it.
std::string_view takePart(std::string_view& text) {
    const std::size_t dot = std::min(text.find('.'), text.size());
    const std::string_view part = text.substr(0, dot);
    text.remove_prefix(std::min(dot + 1, text.size()));
    return part;
}

}  // namespace

std::string toString(const Address& address) {
    std::string text = std::to_string(address.pivot);
    text += '.';
    text += stageName(address.stage);
    if (address.n > 0) text += '.' + std::to_string(address.n);
    return text;
}

std::optional<Address> addressFromString(std::string_view text) {
    if (text.empty() || text.back() == '.') return std::nullopt;
    const auto pivot = numberFrom(takePart(text));
    if (!pivot) return std::nullopt;
    Address address{*pivot, Stage::Pivot, 0};
    if (text.empty()) return address;
    const auto stage = stageFromName(takePart(text));
    if (!stage) return std::nullopt;
    address.stage = *stage;
    if (text.empty()) return address;
    const auto n = numberFrom(text);
    if (!n) return std::nullopt;
    address.n = *n;
    return address;
}

void EventLog::add(std::uint32_t pivot, Stage stage, const Evidence& evidence) {
    if (pivot != pivot_) {
        pivot_ = pivot;
        counts_ = {};
    }
    events_.push_back({{pivot, stage, ++counts_[static_cast<std::size_t>(stage)]}, evidence});
}

void EventLog::clear() {
    events_.clear();
    pivot_ = 0;
    counts_ = {};
}

}  // namespace se
