/// Heights of points over a curved surface that is fitted to them: the measure of noise and of
/// layers.
#pragma once

#include <optional>
#include <span>

#include "spiraling_edge/base/types.h"

namespace se {

/// Heights of a patch of points over the quadric that fits them best.
struct FitHeights {
    /// Root mean square, as far as chance does not lessen it (divided by the points less the six
    /// coefficients). In the unit of the positions; on a smooth surface it is the noise along the
    /// normal.
    double deviation = 0.0;
    /// Mean fourth power over the square of the mean second: 3 for Gaussian noise, 1.8 for heights
    /// that are equally likely in a range, 1 for two thin layers of as many points each. About a
    /// fit to 35 points, 2.75, 2.4 and 1.5.
    double kurtosis = 3.0;
};

/// Fits height = a + b x + c y + d x^2 + e x y + f y^2 over the plane of the first point and the
/// others, by least squares. Nothing with fewer than nine points, or where they do not determine
/// the fit, as in a line.
std::optional<FitHeights> fitQuadric(std::span<const Vec3> position, std::span<const Index> patch);

}  // namespace se
