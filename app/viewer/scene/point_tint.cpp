#include "point_tint.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace se::view {

namespace {

constexpr std::array<PointTintRow, 2> kRows = {{
    {PointTint::Status, "status", "By status"},
    {PointTint::Margin, "margin", "By least margin"},
}};

/// Size of the first step but one.
constexpr int kFirstDecade = -6;

}  // namespace

std::span<const PointTintRow> pointTints() { return kRows; }

const PointTintRow& rowOf(PointTint tint) { return kRows[static_cast<std::size_t>(tint)]; }

std::optional<PointTint> pointTintFromName(std::string_view name) {
    const auto found = std::find_if(kRows.begin(), kRows.end(),
                                    [&](const PointTintRow& row) { return row.name == name; });
    return found == kRows.end() ? std::nullopt : std::optional(found->id);
}

std::optional<std::size_t> marginStep(double margin) {
    if (!std::isfinite(margin)) return std::nullopt;
    std::size_t step = 0;
    double limit = 1e-6;
    while (step + 1 < kMarginSteps && std::abs(margin) >= limit) {
        ++step;
        limit *= 10.0;
    }
    return step;
}

Color marginColor(std::size_t step, Theme theme) {
    const float share = static_cast<float>(step) / static_cast<float>(kMarginSteps - 1);
    // The end that is close to the background color is left out, so that points with large margins
    // stay visible.
    return viridis(theme == Theme::Dark ? 1.0F - 0.68F * share : 0.72F * share);
}

std::string marginStepText(std::size_t step) {
    if (step == 0) return "< 1e-6";
    const int decade = kFirstDecade + static_cast<int>(step) - 1;
    return decade >= -1 ? "0.1" : "1e" + std::to_string(decade);
}

}  // namespace se::view
