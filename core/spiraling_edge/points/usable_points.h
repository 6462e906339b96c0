/// Which points of a file the algorithm can use, and why not the others: what preparing them and
/// examining them share.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "spiraling_edge/base/finite.h"
#include "spiraling_edge/points/point_file.h"

namespace se {

/// Whether a point can take part.
enum class Fitness : std::uint8_t {
    Usable,
    NonFinite,    ///< Its position is not finite.
    NoDirection,  ///< Its normal is zero or not finite.
    Copy,         ///< A usable point with a lower index stands at the very same place.
};

/// The fitness of each point. `normal` may be empty: then none lacks a direction. O(points).
std::vector<Fitness> fitnessOf(std::span<const Vec3> position, std::span<const Vec3> normal);

/// Of each copy the usable point at its place, of each usable point itself, else kNone.
std::vector<Index> originalsOf(std::span<const Vec3> position, std::span<const Fitness> fitness);

inline bool hasDirection(const Vec3& normal) { return isFinite(normal) && normal != Vec3(0.0); }

/// Scales `normal` to unit length; one without direction is left as it is. True if its length was
/// off by more than 1e-3: less is what few digits in a file bring about.
bool scaleToUnit(Vec3& normal);

/// Fails if the columns of the file differ in length, or there are too many points for an Index.
Status checkColumns(const PointFile& file);

}  // namespace se
