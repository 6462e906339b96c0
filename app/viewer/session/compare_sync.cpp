// Two runs have no common clock. Pivots before the first difference are the same in both; after it
// the rest of one run is mapped linearly to the rest of the other, so that both ends coincide and
// the mapping never goes back.
#include "compare_sync.h"

#include <algorithm>

namespace se::view {

bool inStep(const TwinTimes& times, std::uint32_t pivot) {
    return !times.parted || pivot <= times.alike + 1;
}

std::uint32_t twinPivot(const TwinTimes& times, std::uint32_t pivot) {
    if (inStep(times, pivot)) return pivot;
    const std::uint32_t from = times.alike + 1;
    if (times.endA <= from || times.endB <= from) return std::max(from, times.endB);
    const std::uint64_t gone = std::min(pivot, times.endA) - from;
    const std::uint64_t left = times.endA - from;
    return from + static_cast<std::uint32_t>(gone * (times.endB - from) / left);
}

std::size_t twinCursor(std::span<const Event> a, std::size_t cursor, std::span<const Event> b) {
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
