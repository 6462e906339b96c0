/// Points in lines, as of a scanner that is faster along its lines than across them.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "spiraling_edge/points/point_set.h"

namespace se {

/// Distances in lines of points, in scene units: medians over about 256 points.
struct ScanLines {
    double along = 0.0;   ///< Of the two nearest points, in the mean.
    double across = 0.0;  ///< To the nearest that is more across than along its line.
};

/// Points of one line that are this many distances of lines apart stand as lines do: then lists of
/// the nearest reach from line to line.
inline constexpr double kThinnedLines = 0.9;

/// True if the eight nearest reach over four times as far along one axis as across, in the median
/// over about 256 points. `nearest`: the 12 nearest of each point; `present` is false for points to
/// leave out.
bool lieInLines(std::span<const Vec3> position, const std::vector<bool>& present,
                const NeighborLists& nearest);

/// Lines of points; nothing where the points do not lie in lines. Arguments as of lieInLines().
/// O(points).
std::optional<ScanLines> scanLinesOf(std::span<const Vec3> position,
                                     const std::vector<bool>& present,
                                     const NeighborLists& nearest);

}  // namespace se
