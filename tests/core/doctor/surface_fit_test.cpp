/// Heights over a fitted quadric: none over a quadric, the noise over a surface, and two heaps over
/// two layers.
#include "spiraling_edge/doctor/surface_fit.h"

#include <numeric>

#include "doctor_support.h"

using namespace se;
using namespace se::test;

namespace {

/// Points of a paraboloid, each `height(i)` above it.
template <typename Height>
std::vector<Vec3> paraboloid(Index count, Height&& height) {
    Random random(7);
    std::vector<Vec3> position;
    for (Index i = 0; i < count; ++i) {
        const double x = random.between(-1.0, 1.0);
        const double y = random.between(-1.0, 1.0);
        position.emplace_back(x, y, 0.1 * x * x + 0.05 * x * y - 0.08 * y * y + height(i));
    }
    return position;
}

std::vector<Index> allUpTo(Index count) {
    std::vector<Index> patch(count);
    std::iota(patch.begin(), patch.end(), Index{0});
    return patch;
}

}  // namespace

TEST_CASE("surface fit: points of a quadric have no heights over it, wherever it stands") {
    for (const Vec3& origin : {Vec3(0.0), Vec3(5e5, -2e5, 300.0)}) {
        std::vector<Vec3> position = paraboloid(30, [](Index) { return 0.0; });
        for (Vec3& x : position) x = Vec3(x.y, x.z, x.x) + origin;
        const auto deviation = deviationFromQuadric(position, allUpTo(30));
        REQUIRE(deviation.has_value());
        CHECK(*deviation < 0.01);  // The plane of the frame is that of the points.
    }
}

TEST_CASE("surface fit: the deviation is the noise, and layers are two heaps") {
    Random random(3);
    const auto noise = [&](Index) { return random.between(-0.1, 0.1); };
    const auto noisy = heapsOverQuadric(paraboloid(400, noise), allUpTo(400));
    REQUIRE(noisy.has_value());
    CHECK(noisy->deviation == doctest::Approx(0.1 / std::sqrt(3.0)).epsilon(0.1));
    CHECK(noisy->heaps.share == doctest::Approx(0.75).epsilon(0.02));
    const auto layer = [](Index i) { return i % 2 == 0 ? 0.05 : -0.05; };
    const auto layers = heapsOverQuadric(paraboloid(400, layer), allUpTo(400));
    REQUIRE(layers.has_value());
    CHECK(layers->deviation == doctest::Approx(0.05).epsilon(0.1));
    CHECK(layers->heaps.share == doctest::Approx(1.0).epsilon(0.01));
    CHECK(layers->heaps.apart == doctest::Approx(0.1).epsilon(0.01));
    CHECK(layers->heaps.within < 0.01);
    // One point in five on the other layer, with noise.
    const auto few = [&](Index i) { return (i % 5 == 0 ? 0.5 : 0.0) + random.between(-0.1, 0.1); };
    const auto uneven = heapsOverQuadric(paraboloid(400, few), allUpTo(400));
    REQUIRE(uneven.has_value());
    CHECK(uneven->heaps.share > 0.9);
    CHECK(uneven->heaps.apart == doctest::Approx(0.5).epsilon(0.05));
}

TEST_CASE("surface fit: too few points, and points in a line, have none") {
    const std::vector<Vec3> few = paraboloid(8, [](Index) { return 0.0; });
    CHECK_FALSE(deviationFromQuadric(few, allUpTo(8)).has_value());
    CHECK_FALSE(heapsOverQuadric(few, allUpTo(8)).has_value());
    std::vector<Vec3> line;
    for (int i = 0; i < 20; ++i) line.emplace_back(i, 2 * i, -i);
    CHECK_FALSE(deviationFromQuadric(line, allUpTo(20)).has_value());
    CHECK_FALSE(deviationFromQuadric(std::vector<Vec3>(20, Vec3(1.0)), allUpTo(20)).has_value());
}
