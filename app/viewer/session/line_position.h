/// Position of the cursor among decisions in the order of the run.
#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "session.h"
#include "spiraling_edge/why/ledger.h"

namespace se::view {

struct LinePosition {
    std::optional<std::size_t> here;  ///< The decision at the cursor.
    std::size_t before = 0;  ///< Number of decisions before the cursor; it is on the next or above.

    /// The next (+1) or previous (-1) of `count` from the cursor; empty if there is none.
    std::optional<std::size_t> step(int direction, std::size_t count) const;
};

/// Requires session.ready(). `lines` are in the order of the run. O(log lines + events of a pivot).
LinePosition positionAmong(std::span<const LedgerLine> lines, const Session& session);

}  // namespace se::view
