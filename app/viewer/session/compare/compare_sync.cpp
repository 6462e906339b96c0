// Two runs have no common clock. Pivots before the first difference are the same in both; after it
// the rest of one run is mapped linearly to the rest of the other, so that both ends coincide and
// the mapping never goes back.
#include "compare_sync.h"

#include <algorithm>

namespace se::view {

bool inStep(const RunAlignment& alignment, std::uint32_t pivot) {
    return !alignment.parted || pivot <= alignment.alike + 1;
}

std::uint32_t matchingPivot(const RunAlignment& alignment, std::uint32_t pivot) {
    if (inStep(alignment, pivot)) return pivot;
    const std::uint32_t from = alignment.alike + 1;
    if (alignment.endA <= from || alignment.endB <= from) return std::max(from, alignment.endB);
    const std::uint64_t gone = std::min(pivot, alignment.endA) - from;
    const std::uint64_t left = alignment.endA - from;
    return from + static_cast<std::uint32_t>(gone * (alignment.endB - from) / left);
}

std::size_t matchingEvent(std::span<const Event> a, std::size_t cursor, std::span<const Event> b) {
    const std::size_t last = b.size() - 1;
    if (cursor >= a.size() || cursor + 1 == a.size()) return last;
    const Address& here = a[cursor].address;
    std::size_t found = 0;
    for (std::size_t i = 0; i < b.size(); ++i) {
        if (b[i].address == here) return i;
        if (b[i].address.stage <= here.stage) found = i;
    }
    return found;
}

}  // namespace se::view
