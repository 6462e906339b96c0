/// Sides of points that are renumbered for speed: those of the points under their own numbers.
#include "spiraling_edge/prepare/side_forest.h"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "spiraling_edge/prepare/facing.h"
#include "spiraling_edge/prepare/orientation.h"
#include "support/clouds.h"
#include "support/oracles.h"

using namespace se;
using namespace se::test;

namespace {

/// Enough points for areScattered().
constexpr std::size_t kSide = 320;
constexpr std::size_t kMany = kSide * kSide;

std::vector<Index> orderByChance(std::size_t count, std::uint64_t seed) {
    Random random(seed);
    std::vector<Index> order(count);
    for (Index i = 0; i < count; ++i) order[i] = i;
    for (std::size_t i = count; i > 1; --i) std::swap(order[i - 1], order[random.below(i)]);
    return order;
}

/// Points of a lattice in an order by chance, with three different normals: edges have few
/// different weights, and no sides agree along all of them.
struct Lattice {
    std::vector<Vec3> position, normal;
    NeighborLists lists;
};
Lattice scatteredLattice() {
    Lattice made;
    Random random(4);
    constexpr std::array<Vec3, 3> kSome{Vec3(0.6, 0.8, 0), Vec3(0, 0.6, 0.8), Vec3(0.8, 0, 0.6)};
    for (const Index i : orderByChance(kMany, 1)) {
        made.position.push_back(Vec3(i % kSide, i / kSide, 0));
        made.normal.push_back(kSome[random.below(kSome.size())]);
    }
    made.lists = nearestLists(made.position, 8);
    return made;
}

/// The same points and others without normals, each beside those that it lists: as a whole these
/// are not scattered, and keep their numbers.
Lattice withOthers(Lattice points) {
    for (std::size_t i = 0; i < 2 * kMany; ++i) {
        points.position.push_back(Vec3(0.0));
        points.normal.push_back(Vec3(0.0));
        points.lists.append(std::array{static_cast<Index>(points.lists.size() - 1)});
    }
    return points;
}

PointFile sphereInOrder() {
    const double golden = std::numbers::pi * (3.0 - std::sqrt(5.0));
    PointFile file;
    for (std::size_t i = 0; i < kMany; ++i) {
        const double z = 1.0 - static_cast<double>(2 * i + 1) / static_cast<double>(kMany);
        const double turn = golden * static_cast<double>(i);
        const double r = std::sqrt(1.0 - z * z);
        file.position.push_back({r * std::cos(turn), r * std::sin(turn), z});
    }
    return file;
}

}  // namespace

TEST_CASE("side forest: scattered points get the sides as under their own numbers") {
    const Lattice points = scatteredLattice();
    Lattice plain = withOthers(points);
    REQUIRE(areScattered(points.lists));
    REQUIRE_FALSE(areScattered(plain.lists));
    const auto expected = orientNormals(plain.position, plain.lists, plain.normal).value();
    plain.normal.resize(kMany);
    CHECK(expected.turned > kMany / 4);
    for (const unsigned threads : {1U, 2U, 3U}) {
        OrientationOptions options;
        options.threads = threads;
        std::vector<Vec3> normal = points.normal;
        const auto report = orientNormals(points.position, points.lists, normal, options).value();
        CHECK(normal == plain.normal);
        CHECK(report.turned == expected.turned);
        CHECK(report.components == expected.components);
        CHECK(report.unknownSides == expected.unknownSides);
    }
}

TEST_CASE("side forest: cancelled work on scattered points turns and moves nothing") {
    const Lattice points = scatteredLattice();
    std::vector<Vec3> normal = points.normal;
    const auto result = orientNormals(points.position, points.lists, normal, {},
                                      [](double share) { return share < 0.6; });
    CHECK_FALSE(result.ok());
    CHECK(normal == points.normal);
}

TEST_CASE("side forest: scattered points get the derived normals of the same points in order") {
    PrepareOptions options;
    options.normals = NormalSource::Derived;
    const PointFile file = sphereInOrder();
    const std::vector<Index> order = orderByChance(kMany, 2);
    PointFile scattered;
    scattered.position = permuted(file.position, order);
    const PointSet expected = std::move(prepare(file, options).value().points);
    const PointSet found = std::move(prepare(scattered, options).value().points);
    REQUIRE_FALSE(areScattered(expected.neighbors));
    REQUIRE(areScattered(found.neighbors));
    CHECK(found.normal == permuted(expected.normal, order));
}

TEST_CASE("facing: among equal votes, that of the lowest number counts") {
    const std::vector<Vec3> position(2, Vec3(0.0));
    const std::vector<Vec3> normal{Vec3(1, 0, 0), Vec3(-1, 0, 0)};
    const std::vector<Index> component(2, 0);
    const std::vector<Index> number{1, 0};
    const std::vector<bool> listed(2, true);
    CHECK(votesOutward({position, normal, component, 1, listed})[0].clearest == 1.0);
    CHECK(votesOutward({position, normal, component, 1, listed, number})[0].clearest == -1.0);
}
