/// Heights of points over a curved surface that is fitted to them: the measure of noise and of
/// layers.
#pragma once

#include <optional>
#include <span>

#include "spiraling_edge/base/two_heaps.h"
#include "spiraling_edge/base/types.h"

namespace se {

/// The root mean square height of a patch of points over the quadric that fits them best, as far as
/// chance does not lessen it (divided by the points less the six coefficients). In the unit of the
/// positions; on a smooth surface it is the noise along the normal. The quadric is height = a + b x
/// + c y + d x^2 + e x y + f y^2 over the plane of the first point and the others, by least
/// squares. Nothing with fewer than nine points, or where they do not determine the fit, as in a
/// line.
std::optional<double> deviationFromQuadric(std::span<const Vec3> position,
                                           std::span<const Index> patch);

/// Heights of a patch of points over a quadric.
struct FitHeights {
    double deviation = 0.0;  ///< deviationFromQuadric()
    /// Of the heights over a surface that is fitted again to both heaps, one moved onto the other:
    /// a fit to two layers bends between them.
    TwoHeaps heaps{};
};

/// As above, with the heaps of the heights, which takes up to four fits.
std::optional<FitHeights> heapsOverQuadric(std::span<const Vec3> position,
                                           std::span<const Index> patch);

}  // namespace se
