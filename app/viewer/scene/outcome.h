/// The color of the outcome of an event.
#pragma once

#include <optional>

#include "palette.h"
#include "spiraling_edge/stepper/event.h"

namespace se::view {

/// Kept, rejected, moved, or without effect; for an alert that of errors. Empty for an event that
/// has no outcome, such as a new triangle or the next pivot: callers choose the color of those.
std::optional<Color> outcomeColor(const Palette& palette, const Event& event);

}  // namespace se::view
