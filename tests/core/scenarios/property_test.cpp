/// The invariants, after every pivot, over families of inputs.
#include <doctest/doctest.h>

#include "support/clouds.h"
#include "support/random_points.h"

using namespace se;
using namespace se::test;

namespace {

using Level = InvariantChecker::Level;

}  // namespace

TEST_CASE("invariants 1 to 13 hold at every pivot on even closed surfaces, k up to 12") {
    for (const Family& family : closedFamilies(0.45)) {
        for (std::uint64_t seed = 1; seed <= 2; ++seed) {
            const PointFile file = family.sample(seed);
            for (const std::size_t k : {8U, 10U, 12U}) {
                CHECK_MESSAGE(
                    firstBreach(prepared(file, reach(k)), paper(), Level::WellSampled) == "",
                    family.name, " seed ", seed, " k ", k);
            }
        }
    }
}

TEST_CASE("invariants 1 to 13 hold at every pivot with lists by radius") {
    for (const Family& family : closedFamilies(0.45)) {
        const PointFile file = family.sample(4);
        const PointSet nearest = prepared(file, reach(1));
        double mean = 0;
        for (Index p = 0; p < nearest.size(); ++p) {
            mean += glm::length(nearest.position[p] - nearest.position[nearest.neighbors[p][0]]);
        }
        mean /= static_cast<double>(nearest.size());
        const PointSet points = prepared(file, {WithinRadius{1.75 * mean}});
        CHECK_MESSAGE(firstBreach(points, paper(), Level::WellSampled) == "", family.name);
    }
}

TEST_CASE("invariants hold at every pivot on an open sheet in a box") {
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
        for (const ImplicitSurface& sheet : {wavySheet(), flatSheet()}) {
            const PointFile file = sampleSheet(sheet, 8, 80, seed);
            for (const std::size_t k : {8U, 12U}) {
                const PointSet points = prepared(file, reach(k));
                CHECK_MESSAGE(firstBreach(points, paper(), Level::WellSampled) == "", "seed ", seed,
                              " k ", k);
            }
        }
    }
}

TEST_CASE("the invariants of any input hold where lists are long or normals unfiltered") {
    for (const Family& family : closedFamilies(0.4)) {
        const PointFile file = family.sample(5);
        for (const std::size_t k : {16U, 24U}) {
            const PointSet points = prepared(file, reach(k, false));
            CHECK_MESSAGE(firstBreach(points, paper(), Level::AnyInput) == "", family.name, k);
            CHECK_MESSAGE(firstBreach(points, printed(), Level::AnyInput) == "", family.name, k);
        }
    }
}

TEST_CASE("the invariants of any input hold on random points, and every run ends") {
    std::size_t triangles = 0;
    for (std::uint64_t seed = 1; seed <= 200; ++seed) {
        const PointSet points = randomPoints(seed);
        REQUIRE(validate(points).ok());
        for (const std::string_view name : {"paper", "printed"}) {
            const Params params = *paramsByName(name);
            CHECK_MESSAGE(firstBreach(points, params, Level::AnyInput) == "", name, " ", seed);
            const Run run = runAll(points, params);
            CHECK(run.state.finished());
            triangles += run.state.triangles.size();
        }
    }
    CHECK(triangles > 1000);  // They did something.
}

TEST_CASE("6.4 fans turn counterclockwise about the pivot's normal on well-sampled surfaces") {
    for (const Family& family : closedFamilies(0.5)) {
        const PointSet points = prepared(family.sample(2));
        const Run run = runAll(points, paper());
        std::size_t against = 0;
        for (const Triangle& t : run.state.triangles) {
            const Vec3 u = points.position[t.b] - points.position[t.a];
            const Vec3 v = points.position[t.c] - points.position[t.a];
            against += glm::dot(glm::cross(u, v), points.normal[t.a]) > 0 ? 0 : 1;
        }
        CHECK_MESSAGE(against * 100 <= run.state.triangles.size(), family.name);
    }
}
