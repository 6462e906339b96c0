/// Classification of the points of a file as usable or not, and why: shared by prepare() and the
/// doctor.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "spiraling_edge/points/point_file.h"

namespace se {

/// The fitness of a point for the algorithm.
enum class Fitness : std::uint8_t {
    Usable,
    NonFinite,    ///< Its position is not finite.
    NoDirection,  ///< Its normal is zero or not finite.
    Copy,         ///< A usable point with a lower index has exactly the same position.
};

/// The fitness of each point. `normal` may be empty: then none lacks a direction. O(points).
std::vector<Fitness> fitnessOf(std::span<const Vec3> position, std::span<const Vec3> normal);

/// For each copy the usable point at its position, for each usable point itself, else kNone.
std::vector<Index> originalsOf(std::span<const Vec3> position, std::span<const Fitness> fitness);

inline bool hasDirection(const Vec3& normal) { return isFinite(normal) && normal != Vec3(0.0); }

/// Scales `normal` to unit length; one without direction is unchanged. True if its length was off
/// by more than 1e-3: smaller errors come from rounded numbers in a file.
bool scaleToUnit(Vec3& normal);

/// Fails if the columns of the file differ in length, or there are too many points for an Index.
Status checkColumns(const PointFile& file);

}  // namespace se
