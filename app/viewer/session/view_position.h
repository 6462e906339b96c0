/// A position in a run, with the camera, as text: to be copied, pasted and kept.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "scene/camera.h"
#include "session.h"
#include "spiraling_edge/base/result.h"

namespace se::view {

struct ViewPosition {
    std::string address;  ///< As accepted by the go-to box; empty at the start of the run.
    std::optional<CameraPose> camera;
};

/// One line of JSON.
std::string toText(const ViewPosition& place);
/// Parses the result of toText(), or a bare address. Fails with a sentence.
Result<ViewPosition> viewPositionFromText(std::string_view text);

// Position of the cursor among decisions in the order of the run.

struct LinePosition {
    std::optional<std::size_t> here;  ///< The decision at the cursor.
    std::size_t before = 0;  ///< Number of decisions before the cursor; it is on the next or above.

    /// The next (+1) or previous (-1) of `count` from the cursor; empty if there is none.
    std::optional<std::size_t> step(int direction, std::size_t count) const;
};

/// Requires session.ready(). `lines` are in the order of the run. O(log lines + events of a pivot).
LinePosition positionAmong(std::span<const LedgerLine> lines, const Session& session);

}  // namespace se::view
