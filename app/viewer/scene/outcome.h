/// The color of what became of the thing that an event is about.
#pragma once

#include <optional>

#include "palette.h"
#include "spiraling_edge/stepper/event.h"

namespace se::view {

/// Kept, rejected, moved, or without effect; of an alert that of errors. Nothing for an event that
/// has no outcome, such as a new triangle or the next pivot: whoever asks says what those look
/// like.
std::optional<Color> outcomeColor(const Palette& palette, const Event& event);

}  // namespace se::view
