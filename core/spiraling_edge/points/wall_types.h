/// Wall types from a box that cuts the surface (§7).
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "spiraling_edge/points/point_set.h"

namespace se {

/// The box of a domain; walls are its faces.
struct WallBox {
    Vec3 low{0.0}, high{0.0};
    /// Points not farther from a face than this lie on it. In units of the largest side.
    double tolerance = 1e-6;
};

/// A face of the box.
struct WallFace {
    std::uint8_t bit;
    Vec3::length_type axis;
    double sign;  ///< +1: the upper face of that axis.
};
inline constexpr std::array kWallFaces{
    WallFace{kPositiveX, 0, 1.0},  WallFace{kPositiveY, 1, 1.0},  WallFace{kPositiveZ, 2, 1.0},
    WallFace{kNegativeX, 0, -1.0}, WallFace{kNegativeY, 1, -1.0}, WallFace{kNegativeZ, 2, -1.0}};

/// The bounding box of all points with finite positions; {0, 0} if there are none.
WallBox boxAround(std::span<const Vec3> position);

/// TypeBits of each point: the bit of every face that it lies on, the corner bit with two or more.
/// Points outside the box, or not finite, are interior. A side of the box without length has no
/// faces. A face with fewer than three points, which a surface only touches, does not count.
std::vector<std::uint8_t> wallTypes(std::span<const Vec3> position, const WallBox& box);

}  // namespace se
