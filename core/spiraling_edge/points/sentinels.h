/// Sentinels: points whose coordinates stand for a missing value, as depth cameras and rasters
/// write them.
#pragma once

#include <span>
#include <vector>

#include "spiraling_edge/points/point_set.h"

namespace se {

/// Thresholds of markSentinels(), measured on half of the shared sets and judged on the others
/// (docs/doctor.md).
struct SentinelLimits {
    std::size_t leastPoints = 20;  ///< Among fewer points nothing is known.
    /// A value is far off if it is more than this times the span of the points away from their
    /// middle,
    double far = 1000.0;
    double farNamed = 6.0;  ///< or, if such values are written where there is none, than this.
    std::size_t mostUnnamed = 16;  ///< More with values of the first kind are a part of the scan.
    /// A place is far off if its nearest other place is more than this times as far away as the
    /// third nearest of that is.
    double farPlace = 8.0;
    std::size_t copies = 3;   ///< Least number of points at a place that is examined.
    double mostShared = 0.1;  ///< Where more of the places have copies, triangles share points.
};
inline constexpr SentinelLimits kSentinelLimits{};

/// Marks as Aside::Sentinel the points, of those marked No and their copies, with a coordinate far
/// off the others, those with a coordinate below or above all others that several share without
/// being a plane, and all at a place far off the others that several share: kSentinelLimits.
/// `original` has the first point at the place of each, kNone if it is not finite. Requires a mark
/// for each position. Deterministic. O(points).
void markSentinels(std::span<const Vec3> position, std::span<const Index> original,
                   std::vector<Aside>& aside);

}  // namespace se
