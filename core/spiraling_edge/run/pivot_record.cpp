#include "spiraling_edge/run/pivot_record.h"

#include <algorithm>

namespace se {

std::optional<std::size_t> PivotRecord::find(const Address& address) const {
    const auto matches = [&](const Event& event) {
        return event.address.stage == address.stage &&
               (address.n == 0 || event.address.n == address.n);
    };
    if (address.pivot != pivot || events.empty()) return std::nullopt;
    auto found = std::find_if(events.begin(), events.end(), matches);
    const bool whole = address.stage == Stage::Pivot && address.n == 0;
    if (found == events.end() && whole) found = events.begin();
    if (found == events.end()) return std::nullopt;
    return static_cast<std::size_t>(found - events.begin());
}

}  // namespace se
