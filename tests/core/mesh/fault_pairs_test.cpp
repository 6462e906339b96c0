#include "spiraling_edge/mesh/fault_pairs.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <tuple>

#include "spiraling_edge/geometry/exact_predicates.h"
#include "spiraling_edge/geometry/second_layer.h"
#include "support/clouds.h"
#include "support/oracles.h"

using namespace se;
using namespace se::test;

namespace {

struct Strewn {
    PointSet points;
    std::vector<Triangle> triangles;
};

/// Small triangles in any position about points along a diagonal, several of them at each.
Strewn strewnAlongDiagonal(Index count, double step) {
    Random random(7);
    Strewn mesh;
    for (Index i = 0; i < count; ++i) {
        const Vec3 center = step * Vec3(i, 0.9 * i, -0.8 * i);
        for (int k = 0; k < 3; ++k) mesh.points.position.push_back(center + random.inCube());
        mesh.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
    }
    mesh.points.normal.assign(mesh.points.size(), Vec3(0, 0, 1));
    return mesh;
}

bool precedes(const Fault& a, const Fault& b) {
    return std::tie(a.kind, a.triangle, a.other) < std::tie(b.kind, b.triangle, b.other);
}

/// The pairs in order, each once.
FaultSearch search(const Strewn& mesh, const PairLimits& limits, unsigned threads) {
    const std::vector<std::uint8_t> usable(mesh.triangles.size(), 1);
    FaultSearch found = searchPairs(mesh.points, mesh.triangles, usable, limits, threads);
    std::sort(found.faults.begin(), found.faults.end(), precedes);
    found.faults.erase(std::unique(found.faults.begin(), found.faults.end()), found.faults.end());
    return found;
}

}  // namespace

TEST_CASE("fault pairs: found across the borders of the blocks of the grid") {
    // Over more than thirty blocks: 16 cells of 1.5 mean sizes each, along every axis.
    const Strewn mesh = strewnAlongDiagonal(3000, 0.3);
    std::vector<Fault> expected;
    for (Index a = 0; a < mesh.triangles.size(); ++a) {
        // Centers ten steps apart are farther away than any two triangles reach.
        const auto end = std::min<Index>(a + 12, static_cast<Index>(mesh.triangles.size()));
        for (Index b = a + 1; b < end; ++b) {
            const Triangle& one = mesh.triangles[a];
            const Triangle& other = mesh.triangles[b];
            if (trianglesShareMore(mesh.points.position, one, other))
                expected.push_back({FaultKind::Intersecting, a, b});
            if (isSecondLayer(mesh.points, one, other))
                expected.push_back({FaultKind::SecondLayer, a, b});
        }
    }
    std::sort(expected.begin(), expected.end(), precedes);
    CHECK(expected.size() > 1500);
    CHECK(search(mesh, PairLimits::ofMesh(mesh.triangles.size()), 2).faults == expected);
}

TEST_CASE("fault pairs: the same with any number of threads, whichever limit is reached" *
          doctest::test_suite("long")) {
    // Tens of tasks. A few triangles have the size of the whole: tested with all others.
    Strewn mesh = strewnAlongDiagonal(60000, 0.3);
    for (Index i = 0; i < 60000; i += 20000) {
        const Triangle& t = mesh.triangles[i];
        mesh.points.position[t.a] += Vec3(9000, 8000, -7000);
    }
    const PairLimits whole = PairLimits::ofMesh(mesh.triangles.size());
    const FaultSearch all = search(mesh, whole, 1);
    CHECK(all.complete);
    CHECK(all.work > 3'000'000);
    for (const unsigned threads : {2U, 3U, 7U}) {
        const FaultSearch several = search(mesh, whole, threads);
        CHECK(several.faults == all.faults);
        CHECK(several.work == all.work);
    }
    const auto sameWhenEnded = [&](const PairLimits& limits) {
        const FaultSearch one = search(mesh, limits, 1);
        CHECK_FALSE(one.complete);
        CHECK(one.faults.size() < all.faults.size());
        for (const unsigned threads : {2U, 3U, 7U}) {
            const FaultSearch several = search(mesh, limits, threads);
            CHECK(several.faults == one.faults);
            CHECK(several.work == one.work);
        }
    };
    for (const std::uint64_t share : {1U, 3U, 5U, 6U, 7U}) {
        CAPTURE(share);
        sameWhenEnded({share * all.work / 8, whole.flat, whole.found});
        sameWhenEnded({whole.work, whole.flat, share * 3000});
    }
}
