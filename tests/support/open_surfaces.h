/// Surfaces that end without a wall, with the places of their rims.
#pragma once

#include <doctest/doctest.h>

#include <algorithm>

#include "support/clouds.h"
#include "support/oracles.h"

namespace se::test {

/// An open surface with its known rims.
struct Open {
    std::string name;
    PointFile file;
    std::size_t rims = 0;
    double spacing = 0.0;
    std::function<double(const Vec3&)> toRim;  ///< The distance from a place to the nearest rim.
};

inline void add(PointFile& file, const Vec3& x, const Vec3& normal) {
    file.position.push_back(x);
    file.normal.push_back(normal);
}

/// Closed samples with the parts beyond the rims cut away.
inline Open cut(std::string name, const PointFile& whole, std::size_t rims, double spacing,
                std::function<double(const Vec3&)> depth) {
    Open open{std::move(name), {}, rims, spacing, depth};
    for (std::size_t p = 0; p < whole.position.size(); ++p) {
        if (depth(whole.position[p]) > 0.0) add(open.file, whole.position[p], whole.normal[p]);
    }
    return open;
}

inline constexpr std::size_t kSpherePoints = 1500;
inline double sphereSpacing() { return std::sqrt(12.57 / kSpherePoints * 1.1547); }
inline PointFile sphere(std::uint64_t seed) {
    return sampleClosed(unitSphere(), kSpherePoints, sphereSpacing(), seed);
}

/// The sphere without the caps about these directions: `width` is the straight distance from the
/// middle of a cap to its rim.
inline Open sphereWithHoles(const std::vector<Vec3>& directions, double width, std::uint64_t seed) {
    return cut("sphere with " + std::to_string(directions.size()) + " holes", sphere(seed),
               directions.size(), sphereSpacing(), [directions, width](const Vec3& x) {
                   double nearest = 9.0;
                   for (const Vec3& d : directions)
                       nearest = std::min(nearest, glm::length(x - d) - width);
                   return nearest;
               });
}

/// A lattice of triangles in the plane, and rolled up to a cylinder.
inline Open disc(double radius) {
    Open open{"disc", {}, 1, 1.0, [radius](const Vec3& x) { return radius - glm::length(x); }};
    const int reach = static_cast<int>(radius) + 2;
    for (int j = -reach; j <= reach; ++j) {
        for (int i = -2 * reach; i <= 2 * reach; ++i) {
            const Vec3 x(i + 0.5 * j, 0.86602540378443865 * j, 0.0);
            if (open.toRim(x) > 0.0) add(open.file, x, Vec3(0, 0, 1));
        }
    }
    return open;
}
inline Open cylinder() {
    constexpr int kRound = 40;
    constexpr int kRows = 16;
    const double radius = kRound / (2.0 * kPi);
    const double height = 0.86602540378443865 * (kRows - 1);
    Open open{
        "cylinder", {}, 2, 1.0, [height](const Vec3& x) { return std::min(x.z, height - x.z); }};
    for (int j = 0; j < kRows; ++j) {
        for (int i = 0; i < kRound; ++i) {
            const Vec3 out = polar(360.0 * (i + 0.5 * (j % 2)) / kRound);
            add(open.file, radius * out + Vec3(0, 0, 0.86602540378443865 * j), out);
        }
    }
    return open;
}

inline std::vector<Open> openSurfaces() {
    const std::vector<Vec3> axes{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}};
    std::vector<Open> all{disc(8.2), disc(15.6), cylinder()};
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
        all.push_back(cut("hemisphere", sphere(seed), 1, sphereSpacing(),
                          [](const Vec3& x) { return x.z + 0.05; }));
        for (const std::size_t holes : {1U, 2U, 5U}) {
            all.push_back(sphereWithHoles({axes.begin(), axes.begin() + static_cast<int>(holes)},
                                          0.45, seed));
        }
    }
    return all;
}

/// The points moved by up to `share` of the spacing.
inline PointFile shaken(const Open& open, double share, std::uint64_t seed) {
    PointFile file = open.file;
    Random random(seed);
    for (Vec3& x : file.position) x += share * open.spacing * random.inCube();
    return file;
}

inline Prepared withRim(const PointFile& file) {
    PrepareOptions options;
    options.rim = true;
    auto result = prepare(file, options);
    REQUIRE(result.ok());
    return std::move(result.value());
}

}  // namespace se::test
