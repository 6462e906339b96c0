/// Search for a surface: its crossings with the edges of a lattice over the box, and its curves on
/// the walls. Finds every part of the surface that separates two corners of a cell.
#pragma once

#include <vector>

#include "spiraling_edge/base/progress.h"
#include "spiraling_edge/base/result.h"
#include "spiraling_edge/sampling/surface.h"

namespace se::sampling {

/// A place on the surface, and the area that it represents: the sum of the areas is an unbiased
/// estimate of the whole. Along an axis, lines `a` apart in both directions meet a patch of area A
/// whose unit normal has the component n A |n| / a^2 times; weighted with |n| a^2 and summed over
/// the three axes, that gives A (n_x^2 + n_y^2 + n_z^2) = A.
struct Crossing {
    Vec3 position;
    double area;
};

/// Fails if `progress` cancels.
Result<std::vector<Crossing>> findCrossings(const Surface& surface, unsigned threads,
                                            const Progress& progress);

/// A curve of the surface on one wall: places in order, the first repeated at the end if it is
/// closed. An open one begins and ends at corners, on two walls.
struct WallCurve {
    std::uint8_t face = kInterior;  ///< TypeBits of the wall.
    std::vector<Vec3> line;
    bool closed() const { return line.front() == line.back(); }
};
std::vector<WallCurve> findWallCurves(const Surface& surface);

}  // namespace se::sampling
