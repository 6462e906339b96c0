/// Events in plain words.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "spiraling_edge/points/point_name.h"
#include "spiraling_edge/stepper/event.h"

namespace se {

/// One plain sentence with its numbers; the same on screen, on stdout and in golden logs. Points
/// have the names of `names`, such as the letters of a figure (scenes/figures.h), else their
/// numbers.
std::string describe(const Event& event, std::span<const PointName> names = {});
/// The words for the verdict of an event; "now start" or "now end" for a candidate that start or
/// end moved to. Empty for an event without a test.
std::string_view endingText(const Event& event);
/// "triangle_cap", "hole", "lost_seed".
std::string_view alertName(AlertKind kind);

}  // namespace se
