#include "line_position.h"

#include <algorithm>
#include <cassert>

namespace se::view {

std::optional<std::size_t> LinePosition::step(int direction, std::size_t count) const {
    if (direction < 0) return before > 0 ? std::optional(before - 1) : std::nullopt;
    const std::size_t next = before + (here ? 1 : 0);
    return next < count ? std::optional(next) : std::nullopt;
}

LinePosition positionAmong(std::span<const LedgerLine> lines, const Session& session) {
    assert(session.ready());
    const PivotRecord& record = session.record();
    // Within a pivot the stages do not always come in one order, so its events are searched.
    const auto isBefore = [&](const LedgerLine& line) {
        const Address& address = line.event.address;
        if (address.pivot != record.pivot) return address.pivot < record.pivot;
        const auto place = record.find(address);
        return session.event() != nullptr && place && *place < session.cursor();
    };
    LinePosition place;
    const auto first = std::partition_point(lines.begin(), lines.end(), isBefore);
    place.before = static_cast<std::size_t>(first - lines.begin());
    const bool here = first != lines.end() && session.event() != nullptr &&
                      first->event.address == session.address();
    if (here) place.here = place.before;
    return place;
}

}  // namespace se::view
