/// Colorings of the points of the input. Their shapes show their status in all of them.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "palette.h"

namespace se::view {

enum class PointTint : std::uint8_t {
    Status,  ///< UNUSED, USED, DONE.
    Margin,  ///< How close any test of it came to going the other way.
};

/// One row of the table of tints.
struct PointTintRow {
    PointTint id;
    std::string_view name;   ///< In settings, actions and --point-tint.
    std::string_view title;  ///< Name for the user.
};
std::span<const PointTintRow> pointTints();
const PointTintRow& rowOf(PointTint tint);
std::optional<PointTint> pointTintFromName(std::string_view name);

/// Margins by decades: below 1e-6, below 1e-5 ... below 0.1, and the rest.
inline constexpr std::size_t kMarginSteps = 7;
/// The step of a margin, regardless of its sign; 0: closest to going the other way. Empty if it is
/// not finite.
std::optional<std::size_t> marginStep(double margin);
/// The closer to going the other way, the more it contrasts with the background.
Color marginColor(std::size_t step, Theme theme);
/// "< 1e-6", "1e-6", ... : the lower end of a step.
std::string marginStepText(std::size_t step);

}  // namespace se::view
