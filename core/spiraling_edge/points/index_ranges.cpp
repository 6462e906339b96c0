#include "spiraling_edge/points/index_ranges.h"

#include <algorithm>

#include "spiraling_edge/base/text_scan.h"

namespace se {

namespace {

constexpr std::string_view kTo = "..";

/// "3..9" or "40".
std::optional<IndexRange> rangeFromText(std::string_view text) {
    const std::size_t to = text.find(kTo);
    const auto first = numberIn<Index>(text.substr(0, to));
    const auto last =
        to == std::string_view::npos ? first : numberIn<Index>(text.substr(to + kTo.size()));
    if (!first || !last || *last < *first || *last == kNone) return std::nullopt;
    return IndexRange{*first, *last};
}

}  // namespace

IndexRanges rangesOf(std::span<const Index> indices) {
    std::vector<IndexRange> ranges;
    for (const Index i : indices) {
        if (!ranges.empty() && ranges.back().last + 1 == i) {
            ranges.back().last = i;
        } else {
            ranges.push_back({i, i});
        }
    }
    return IndexRanges(std::move(ranges));
}

std::string rangesText(const IndexRanges& ranges) {
    std::string text;
    for (const auto& [first, last] : ranges.all()) {
        if (!text.empty()) text += ',';
        text += std::to_string(first);
        if (last == first) continue;
        text += last == first + 1 ? "," : kTo;
        text += std::to_string(last);
    }
    return text;
}

std::optional<IndexRanges> rangesFromText(std::string_view text) {
    std::vector<IndexRange> ranges;
    while (!text.empty()) {
        const std::size_t comma = text.find(',');
        const std::optional<IndexRange> range = rangeFromText(text.substr(0, comma));
        if (!range || (!ranges.empty() && range->first <= ranges.back().last)) return std::nullopt;
        if (!ranges.empty() && ranges.back().last + 1 == range->first) {
            ranges.back().last = range->last;
        } else {
            ranges.push_back(*range);
        }
        if (comma == std::string_view::npos) break;
        text.remove_prefix(comma + 1);
        if (text.empty()) return std::nullopt;
    }
    return IndexRanges(std::move(ranges));
}

std::vector<bool> marksOf(const IndexRanges& ranges, std::size_t count) {
    std::vector<bool> marks(count, false);
    for (const auto& [first, last] : ranges.all()) {
        for (std::size_t i = first; i < count && i <= last; ++i) marks[i] = true;
    }
    return marks;
}

}  // namespace se
