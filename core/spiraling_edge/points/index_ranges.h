/// A set of point indices as ranges: compact where neighbors in a file are neighbors in space.
#pragma once

#include <initializer_list>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "spiraling_edge/base/types.h"

namespace se {

/// The indices from `first` to `last`, both included.
struct IndexRange {
    Index first = 0;
    Index last = 0;
    friend bool operator==(const IndexRange&, const IndexRange&) = default;
};

/// Ascending ranges with a gap between any two. Copies share them: there may be a hundred thousand,
/// and every undo entry has a copy.
class IndexRanges {
  public:
    IndexRanges() = default;
    IndexRanges(std::initializer_list<IndexRange> ranges)
        : IndexRanges(std::vector<IndexRange>(ranges)) {}
    explicit IndexRanges(std::vector<IndexRange> ranges) {
        if (!ranges.empty())
            ranges_ = std::make_shared<const std::vector<IndexRange>>(std::move(ranges));
    }

    bool empty() const { return ranges_ == nullptr; }
    std::span<const IndexRange> all() const {
        return empty() ? std::span<const IndexRange>{} : std::span<const IndexRange>(*ranges_);
    }
    friend bool operator==(const IndexRanges& a, const IndexRanges& b) {
        return a.ranges_ == b.ranges_ || (!a.empty() && !b.empty() && *a.ranges_ == *b.ranges_);
    }

  private:
    std::shared_ptr<const std::vector<IndexRange>> ranges_;  ///< Null: none.
};

/// The ranges of `indices`, which ascend.
IndexRanges rangesOf(std::span<const Index> indices);
/// "3..9,40"; empty for no ranges.
std::string rangesText(const IndexRanges& ranges);
/// Parses such a text; empty if it is none, or if the indices do not ascend.
std::optional<IndexRanges> rangesFromText(std::string_view text);
/// For each index below `count`: true if it is in a range.
std::vector<bool> marksOf(const IndexRanges& ranges, std::size_t count);

}  // namespace se
