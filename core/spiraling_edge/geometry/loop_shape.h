/// What an edge ring that came to rest encloses, or any other closed chain of points, as a shape in
/// space.
#pragma once

#include "phases.h"

namespace se {

/// Narrower, on average, than this many of its edges, a ring is no opening but a seam that did not
/// close: where the spacing changes, neighbors leave wide gaps too.
inline constexpr double kNarrowestOpening = 2.5;

struct RingShape {
    Index length = 0;
    double perimeter = 0.0;
    double area = 0.0;  ///< Of the ring seen from where it looks largest.
    /// Seen along the normals of its points it turns counterclockwise, as round a patch of the
    /// surface. Round a hole it turns clockwise, for the hole lies in the free sectors of its
    /// points.
    bool turnsRoundPatch = false;

    /// The side of the square, or the diameter of the circle, of the same perimeter and area.
    double width() const { return perimeter > 0.0 ? 4.0 * area / perimeter : 0.0; }
    /// The same in edges of the ring: 1 for a square of four edges, n / pi for a round one of n.
    double widthInEdges() const {
        return perimeter > 0.0 ? width() * static_cast<double>(length) / perimeter : 0.0;
    }
};

/// Of the active ring.
RingShape shapeOfRing(const StepContext& context);
/// Of these points in this order, closed. Requires at least one.
RingShape shapeOfLoop(std::span<const Vec3> position, std::span<const Vec3> normal,
                      std::span<const Index> loop);

}  // namespace se
