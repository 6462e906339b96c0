/// The computations of the rules in the plainest way: by angles, by solving equations, by trying
/// all.
#pragma once

#include <cmath>
#include <cstdint>

#include "spiraling_edge/base/random.h"
#include "spiraling_edge/points/point_set.h"

namespace se::test {

inline constexpr double kPi = 3.14159265358979323846;

/// The random numbers of core, in the forms that tests need.
class Random : public SplitMix {
  public:
    using SplitMix::SplitMix;
    double between(double low, double high) { return low + (high - low) * unit(); }
    std::size_t below(std::size_t count) { return static_cast<std::size_t>(bits() % count); }
    Vec3 inCube() {
        const double x = between(-1, 1);
        const double y = between(-1, 1);
        return {x, y, between(-1, 1)};
    }
    Vec3 direction() {
        for (;;) {
            const Vec3 v = inCube();
            const double lengthSq = glm::dot(v, v);
            if (lengthSq > 0.01 && lengthSq < 1.0) return v / std::sqrt(lengthSq);
        }
    }
};

/// A unit vector at this angle to another one, by chance about it.
inline Vec3 tilted(const Vec3& normal, double degrees, Random& random) {
    const Vec3 across = glm::normalize(glm::cross(normal, random.direction()));
    const double angle = degrees * kPi / 180.0;
    return std::cos(angle) * normal + std::sin(angle) * across;
}

/// Point of the plane z = 0 at an angle from the x axis.
inline Vec3 polar(double degrees, double radius = 1.0) {
    return {radius * std::cos(degrees * kPi / 180.0), radius * std::sin(degrees * kPi / 180.0), 0};
}

/// Counterclockwise angle from a to b about the z axis, in [0, 360).
inline double turnDegrees(const Vec3& a, const Vec3& b) {
    const double degrees = (std::atan2(b.y, b.x) - std::atan2(a.y, a.x)) * 180.0 / kPi;
    return degrees < 0 ? degrees + 360.0 : degrees;
}

/// Center of the circle through three points, by solving |c - a|^2 = |c - b|^2 = |c - d|^2 within
/// their plane (Cramer's rule).
inline Vec3 circumcenter(const Vec3& a, const Vec3& b, const Vec3& d) {
    const Vec3 u = b - a;
    const Vec3 v = d - a;
    const double uu = glm::dot(u, u);
    const double uv = glm::dot(u, v);
    const double vv = glm::dot(v, v);
    const double det = uu * vv - uv * uv;
    const double s = (uu / 2 * vv - vv / 2 * uv) / det;
    const double t = (vv / 2 * uu - uu / 2 * uv) / det;
    return a + s * u + t * v;
}

}  // namespace se::test
