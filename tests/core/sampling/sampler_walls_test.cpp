#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "spiraling_edge/sampling/sampler.h"

using namespace se;

namespace {

PointFile sampled(const Field& field) {
    SamplerOptions options;
    options.count = 1500;
    Result<PointFile> file = sample(field, options);
    REQUIRE_MESSAGE(file.ok(), (file.ok() ? "" : file.error().message));
    return std::move(file.value());
}

/// A shape cut by three additional walls.
Field cut(const char* shape) {
    Field field = fieldOf(*findShape(shape));
    field.low.y = -0.77;
    field.high.x = 0.35;
    field.high.z = 0.2;
    return field;
}

/// The nearest along the curve of the surface on p's wall, before and after p; no gap where the
/// curve has ended.
std::array<double, 2> gapsAt(const PointFile& file, std::size_t p) {
    constexpr double kNone = 1e300;
    std::array<double, 2> gaps{kNone, kNone};
    const std::uint8_t faces = file.type[p] & kFaceBits;
    Vec3 across(0.0);
    for (unsigned axis = 0; axis < 3; ++axis) {
        if ((faces & (9U << axis)) != 0) across[static_cast<int>(axis)] = 1.0;
    }
    const Vec3 along = glm::cross(file.normal[p], across);
    for (std::size_t q = 0; q < file.position.size(); ++q) {
        if (q == p || (file.type[q] & faces) == 0) continue;
        if (glm::dot(file.normal[p], file.normal[q]) <= 0.0) continue;
        const Vec3 d = file.position[q] - file.position[p];
        double& gap = gaps[glm::dot(d, along) > 0.0 ? 1 : 0];
        gap = std::min(gap, glm::length(d));
    }
    return gaps;
}

struct Chains {
    double variation = 0.0;  ///< Standard deviation of the gaps over their mean.
    std::size_t points = 0;
    bool exact = true;  ///< Each lies exactly on its walls.
};
Chains chainsOf(const Field& field, const PointFile& file) {
    Chains chains;
    double count = 0.0;
    double sum = 0.0;
    double squares = 0.0;
    for (std::size_t p = 0; p < file.position.size(); ++p) {
        if (!isBoundary(file.type[p])) continue;
        ++chains.points;
        for (unsigned axis = 0; axis < 3; ++axis) {
            const int i = static_cast<int>(axis);
            const double x = file.position[p][i];
            if ((file.type[p] & (1U << axis)) != 0) chains.exact &= x == field.high[i];
            if ((file.type[p] & (8U << axis)) != 0) chains.exact &= x == field.low[i];
        }
        if (isCorner(file.type[p])) continue;
        for (const double gap : gapsAt(file, p)) {
            REQUIRE(gap < 1e300);
            count += 1.0;
            sum += gap;
            squares += gap * gap;
        }
    }
    const double mean = sum / count;
    chains.variation = std::sqrt(std::max(squares / count - mean * mean, 0.0)) / mean;
    return chains;
}

}  // namespace

TEST_CASE("chains of particles on walls are evenly spaced, and lie exactly on them") {
    for (const Field& field : {cut("sphere"), cut("torus"), fieldOf(*findShape("gyroid")),
                               fieldOf(*findShape("monkey-saddle")),
                               fieldOf(*findShape("hyperboloid")), fieldOf(*findShape("plane"))}) {
        const Chains chains = chainsOf(field, sampled(field));
        CAPTURE(chains.points);
        CHECK(chains.points > 50);
        CHECK(chains.exact);
        CHECK(chains.variation < 0.05);
    }
}

TEST_CASE("particles on walls spread along them: an uneven beginning does not stay") {
    // Curves on walls are followed by straight lines through few cells, and hence divided unevenly.
    Field field = cut("torus");
    field.cells = glm::ivec3(5);
    SamplerOptions options;
    options.count = 1500;
    Result<Sampler> begun = Sampler::begin(field, options);
    REQUIRE(begun.ok());
    Sampler& sampler = begun.value();
    const PointFile first = sampler.points();
    while (!sampler.done()) sampler.step();
    const PointFile last = sampler.points();
    CHECK(chainsOf(field, first).variation > 0.08);
    CHECK(chainsOf(field, last).variation < 0.04);
    CHECK(chainsOf(field, last).exact);
    // Corners stay, and the points on the walls keep their number.
    const auto cornersOf = [](const PointFile& file) {
        std::vector<Vec3> corners;
        for (std::size_t p = 0; p < file.position.size(); ++p) {
            if (isCorner(file.type[p])) corners.push_back(file.position[p]);
        }
        std::sort(corners.begin(), corners.end(), [](const Vec3& a, const Vec3& b) {
            return glm::dot(a - b, Vec3(1, 2, 4)) < 0.0;
        });
        return corners;
    };
    const std::vector<Vec3> before = cornersOf(first);
    const std::vector<Vec3> after = cornersOf(last);
    REQUIRE(before.size() == after.size());
    CHECK(before.size() > 3);
    for (std::size_t i = 0; i < before.size(); ++i)
        CHECK(glm::length(before[i] - after[i]) < 1e-9);  // settled to the last digits
    CHECK(chainsOf(field, first).points == chainsOf(field, last).points);
}
