#include "spiraling_edge/geometry/implicit_surfaces.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace se {
namespace {

constexpr double kTube = 0.4;

/// Signed distance to a torus about the z axis.
double torusValue(const Vec3& x) {
    const double across = std::sqrt(x.x * x.x + x.y * x.y) - 1.0;
    return std::sqrt(across * across + x.z * x.z) - kTube;
}
Vec3 torusGradient(const Vec3& x) {
    const double rho = std::max(std::sqrt(x.x * x.x + x.y * x.y), 1e-9);
    const double across = rho - 1.0;
    const double length = std::max(std::sqrt(across * across + x.z * x.z), 1e-9);
    return Vec3(x.x / rho * across, x.y / rho * across, x.z) / length;
}

/// The same torus moved along x and turned about it: a link of the first one's chain.
Vec3 toSecondLink(const Vec3& x) { return {x.x - 1.0, x.z, -x.y}; }
Vec3 fromSecondLink(const Vec3& v) { return {v.x, -v.z, v.y}; }

/// Two tori side by side, squared distances multiplied: a level above zero merges them.
constexpr double kApart = 1.2;
constexpr double kMelt = 0.03;
double squareTorus(const Vec3& x) {
    const double across = std::sqrt(x.x * x.x + x.y * x.y) - 1.0;
    return across * across + x.z * x.z - kTube * kTube;
}
Vec3 squareTorusGradient(const Vec3& x) {
    const double rho = std::max(std::sqrt(x.x * x.x + x.y * x.y), 1e-9);
    const double across = 2.0 * (rho - 1.0) / rho;
    return {x.x * across, x.y * across, 2.0 * x.z};
}
const Vec3 kLeft(-kApart, 0.0, 0.0);

double wave(const Vec3& x) { return 0.25 * x.x * (1.5 - 2.0 * x.x * x.x) + 0.2 * x.y * x.y; }

}  // namespace

ImplicitSurface unitSphere() {
    return {[](const Vec3& x) { return glm::dot(x, x) - 1.0; },
            [](const Vec3& x) { return 2.0 * x; }, Vec3(-1.3), Vec3(1.3)};
}

ImplicitSurface torus() {
    return {torusValue, torusGradient, Vec3(-1.6, -1.6, -0.6), Vec3(1.6, 1.6, 0.6)};
}

ImplicitSurface linkedTori() {
    const auto value = [](const Vec3& x) {
        return std::min(torusValue(x), torusValue(toSecondLink(x)));
    };
    const auto gradient = [](const Vec3& x) {
        const Vec3 y = toSecondLink(x);
        return torusValue(x) <= torusValue(y) ? torusGradient(x) : fromSecondLink(torusGradient(y));
    };
    return {value, gradient, Vec3(-1.6, -1.6, -1.6), Vec3(2.6, 1.6, 1.6)};
}

ImplicitSurface doubleTorus() {
    const auto value = [](const Vec3& x) {
        return squareTorus(x - kLeft) * squareTorus(x + kLeft) - kMelt;
    };
    const auto gradient = [](const Vec3& x) {
        return squareTorusGradient(x - kLeft) * squareTorus(x + kLeft) +
               squareTorusGradient(x + kLeft) * squareTorus(x - kLeft);
    };
    return {value, gradient, Vec3(-2.8, -1.6, -0.6), Vec3(2.8, 1.6, 0.6)};
}

ImplicitSurface flatSheet() {
    return {[](const Vec3& x) { return x.z; }, [](const Vec3&) { return Vec3(0.0, 0.0, 1.0); },
            Vec3(-1.0, -1.0, 0.0), Vec3(1.0, 1.0, 0.0)};
}

ImplicitSurface wavySheet() {
    return {[](const Vec3& x) { return x.z - wave(x); },
            [](const Vec3& x) { return Vec3(-0.25 * (1.5 - 6.0 * x.x * x.x), -0.4 * x.y, 1.0); },
            Vec3(-1.0, -1.0, -1.0), Vec3(1.0, 1.0, 1.0)};
}

ImplicitSurface gyroid() {
    return {[](const Vec3& x) {
                return std::sin(x.x) * std::cos(x.y) + std::sin(x.y) * std::cos(x.z) +
                       std::sin(x.z) * std::cos(x.x);
            },
            [](const Vec3& x) {
                return Vec3(std::cos(x.x) * std::cos(x.y) - std::sin(x.z) * std::sin(x.x),
                            std::cos(x.y) * std::cos(x.z) - std::sin(x.x) * std::sin(x.y),
                            std::cos(x.z) * std::cos(x.x) - std::sin(x.y) * std::sin(x.z));
            },
            Vec3(-4.0), Vec3(4.0)};
}

}  // namespace se
