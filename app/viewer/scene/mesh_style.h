/// Styles of finished triangles, and colorings of points.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "palette.h"
#include "run/overview.h"
#include "run/repair_diff.h"

namespace se::view {

enum class MeshStyle : std::uint8_t {
    Faults,  ///< Flat; at the end of the run, faults are colored.
    Flat,
    Shaded,         ///< Smooth, by the normals of the points.
    Wire,           ///< Only edges.
    CreationOrder,  ///< The earlier a triangle was made, the darker.
    Component,      ///< A color for each component.
};

/// One row of the table of styles, or of tints.
template <typename Id>
struct StyleRow {
    Id id;
    std::string_view name;   ///< In settings, actions, --mesh-style and --point-tint.
    std::string_view title;  ///< Name for the user.
};
using MeshStyleRow = StyleRow<MeshStyle>;
std::span<const MeshStyleRow> meshStyles();
const MeshStyleRow& rowOf(MeshStyle style);
std::optional<MeshStyle> meshStyleFromName(std::string_view name);
/// The next style; after the last, the first.
MeshStyle following(MeshStyle style);

/// Inputs of the mesh colors.
struct MeshColoring {
    MeshStyle style = MeshStyle::Faults;
    std::size_t creationEnd = 1;      ///< Triangles of the run known so far.
    std::vector<std::size_t> starts;  ///< The first triangle of each component.
    /// Components of the repaired mesh, where it is shown.
    std::vector<ComponentStretch> repaired = {};
    friend bool operator==(const MeshColoring&, const MeshColoring&) = default;
};
/// `known`: triangles seen so far, in case the overview lags behind.
MeshColoring meshColoring(MeshStyle style, const RunOverview& run, std::size_t known);

/// Color of the component with that number, counted from 0: neighbors differ.
Color componentColor(std::size_t component);

// Colorings of the points. Their shapes show their status in all of them.

enum class PointTint : std::uint8_t {
    Status,  ///< UNUSED, USED, DONE.
    Margin,  ///< How close any test of it came to going the other way.
};

using PointTintRow = StyleRow<PointTint>;
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
