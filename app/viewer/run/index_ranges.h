/// A set of point indices as ranges: compact where neighbors in a file are neighbors in space.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "spiraling_edge/base/types.h"

namespace se::view {

/// The indices from `first` to `last`, both included.
struct IndexRange {
    Index first = 0;
    Index last = 0;
    friend bool operator==(const IndexRange&, const IndexRange&) = default;
};

/// Ascending, with a gap between any two.
using IndexRanges = std::vector<IndexRange>;

/// The ranges of `indices`, which ascend.
IndexRanges rangesOf(std::span<const Index> indices);
/// "3..9,40"; empty for no ranges.
std::string rangesText(const IndexRanges& ranges);
/// Parses such a text; empty if it is none, or if the indices do not ascend.
std::optional<IndexRanges> rangesFromText(std::string_view text);
/// For each index below `count`: true if it is in a range.
std::vector<bool> marksOf(const IndexRanges& ranges, std::size_t count);

}  // namespace se::view
