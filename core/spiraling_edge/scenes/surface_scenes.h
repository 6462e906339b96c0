/// Even sampling of implicit surfaces for the built-in scenes, after the particle systems that the
/// paper's points come from (§3): random points repel each other and are pulled back onto the
/// surface. Only + - * / and sqrt: equal on every machine.
#pragma once

#include <cstdint>

#include "spiraling_edge/geometry/implicit_surfaces.h"
#include "spiraling_edge/points/point_file.h"
#include "spiraling_edge/prepare/prepare.h"

namespace se {

/// `count` points about `spacing` apart (the two must fit the area), with gradient normals.
PointFile sampleClosed(const ImplicitSurface& surface, std::size_t count, double spacing,
                       std::uint64_t seed);

/// A sheet z = f(x, y) over the rectangle of its box: `perSide` points besides the corners on each
/// of the four walls, typed, and `interior` points between them.
PointFile sampleSheet(const ImplicitSurface& sheet, std::size_t perSide, std::size_t interior,
                      std::uint64_t seed);

/// The face bits, with the corner bit, of a point of a sheet over the rectangle from `low` to
/// `high`.
std::uint8_t wallsAt(const Vec3& x, const Vec3& low, const Vec3& high);

/// The file with lists of this reach, so that what it shows does not depend on options.
PointFile withNeighborLists(PointFile file, const NeighborOptions& reach);

/// The file with its first `count` points moved to the end.
PointFile movedToBack(PointFile file, std::ptrdiff_t count);
/// A sheet of 50 points, with lists of k, whose run begins at an interior point.
PointFile smallSheet(const ImplicitSurface& sheet, std::uint64_t seed, std::size_t k);
/// A torus of 160 points, with lists of k.
PointFile torusOf160(std::uint64_t seed, std::size_t k);

}  // namespace se
