/// A value that several points share along one axis, below or above all others: where rasters and
/// depth cameras have none, or a plane.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "spiraling_edge/points/point_set.h"

namespace se {

/// Points whose coordinate along an axis is the least of all, or the greatest.
struct SharedValue {
    Vec3::length_type axis = 0;
    double value = 0.0;
    std::vector<Index> points;  ///< Ascending.
    double gap = 0.0;           ///< To the nearest value of the other points,
    double range = 0.0;         ///< which reach this far.
};
/// That of the points marked No; nothing where all have it. `sign`: 1 for the least, -1 for the
/// greatest.
std::optional<SharedValue> sharedValueOf(std::span<const Vec3> position,
                                         std::span<const Aside> aside, Vec3::length_type axis,
                                         double sign);

/// True if the others have no gap along the axis that is nearly as wide as that to the value: they
/// are no levels of one kind. O(points log points).
bool isApart(std::span<const Vec3> position, std::span<const Aside> aside,
             const SharedValue& shared);

/// True if points with such a value lie scattered among the others, seen along the axis: in the
/// order of the file and in space. Those of a plane lie beside each other.
bool isScattered(std::span<const Vec3> position, std::span<const Aside> aside,
                 const SharedValue& shared);

/// True if the coordinates of all points marked No are whole numbers, as of pixels.
bool areWhole(std::span<const Vec3> position, std::span<const Aside> aside);

/// True if all points marked No are a raster, seen along the axis.
bool isRaster(std::span<const Vec3> position, std::span<const Aside> aside,
              const SharedValue& shared);

}  // namespace se
