#include "shapes.h"

#include <cmath>
#include <numbers>
#include <random>
#include <utility>

namespace se::bench {
namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;

void add(PointFile& file, const Vec3& position, const Vec3& normal) {
    file.position.push_back(position);
    file.normal.push_back(normal);
}

}  // namespace

PointFile sphere(std::size_t count) {
    PointFile file;
    const double goldenAngle = kTurn * (2.0 - std::numbers::phi);
    for (std::size_t i = 0; i < count; ++i) {
        const double z = 1.0 - (2.0 * static_cast<double>(i) + 1.0) / static_cast<double>(count);
        const double r = std::sqrt(1.0 - z * z);
        const double angle = goldenAngle * static_cast<double>(i);
        const Vec3 p(r * std::cos(angle), r * std::sin(angle), z);
        add(file, p, p);
    }
    return file;
}

PointFile torus(std::size_t count) {
    constexpr double kTube = 0.4;
    PointFile file;
    // Laps of the helix at which its pitch equals the distance along it: an even cover.
    const double laps = std::round(std::sqrt(static_cast<double>(count) / kTube));
    for (std::size_t i = 0; i < count; ++i) {
        const double share = static_cast<double>(i) / static_cast<double>(count);
        const double u = kTurn * share;
        const double v = kTurn * share * laps;
        const Vec3 normal(std::cos(v) * std::cos(u), std::cos(v) * std::sin(u), std::sin(v));
        add(file, Vec3(std::cos(u), std::sin(u), 0.0) + kTube * normal, normal);
    }
    return file;
}

PointFile shuffled(PointFile file) {
    std::mt19937 random(1);
    for (std::size_t i = file.position.size(); i > 1; --i) {
        const std::size_t j = random() % i;
        std::swap(file.position[i - 1], file.position[j]);
        std::swap(file.normal[i - 1], file.normal[j]);
    }
    return file;
}

}  // namespace se::bench
