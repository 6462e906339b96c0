#include "spiraling_edge/mesh/fault_places.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <numeric>
#include <set>

#include "spiraling_edge/base/disjoint_sets.h"
#include "support/clouds.h"

using namespace se;
using namespace se::test;

namespace {

MeshFailure failureAt(std::string_view kind, std::vector<Index> points, double length = 0.0) {
    MeshFailure failure;
    failure.kind = findFailureClass(kind);
    failure.points = std::move(points);
    failure.length = length;
    return failure;
}

PointSet alongX(std::initializer_list<double> xs) {
    PointSet points;
    for (const double x : xs) points.position.emplace_back(x, 0, 0);
    return points;
}

using Positions = std::vector<std::size_t>;

}  // namespace

TEST_CASE("places: faults nearer than three mean edges, or connected, are one place") {
    const PointSet points = alongX({0, 2.9, 6, 100, 200});
    const std::vector<MeshFailure> failures{
        failureAt("unused_points", {0}), failureAt("unused_points", {1}),
        failureAt("unused_points", {2}), failureAt("folded_edges", {3, 4}),
        failureAt("flipped_triangles", {4})};
    const auto places = faultPlaces(points, failures, 1.0);
    REQUIRE(places.size() == 3);
    CHECK(places[0].faults == Positions{0, 1});
    CHECK(places[1].faults == Positions{2});
    CHECK(places[2].faults == Positions{3, 4});
    CHECK(places[0].center.x == doctest::Approx(1.45));
    CHECK(places[0].radius == doctest::Approx(1.45));
    CHECK(places[2].radius == doctest::Approx(50.0));
    // Through a chain of near faults.
    CHECK(faultPlaces(points, failures, 1.1).size() == 2);
}

TEST_CASE("places: holes come first, the longest before the others, flipped triangles last") {
    const PointSet points = alongX({0, 100, 200, 300, 400, 410, 420});
    const std::vector<MeshFailure> failures{failureAt("flipped_triangles", {0}),
                                            failureAt("holes", {1}, 3.0),
                                            failureAt("holes", {2}, 5.0),
                                            failureAt("unused_points", {3}),
                                            failureAt("unused_points", {4}),
                                            failureAt("intersecting_triangles", {4, 5}),
                                            failureAt("slivers", {6})};
    const auto places = faultPlaces(points, failures, 1.0);
    std::vector<std::size_t> first;
    for (const FaultPlace& place : places) first.push_back(place.faults.front());
    // Of the unused points that with more faults beside it; a sliver is no fault.
    CHECK(first == Positions{2, 1, 4, 3, 0});
    CHECK(describe(places[2], failures) == "1 unused point, 1 intersecting pair");
}

TEST_CASE("places: as if all pairs of points of all faults were compared") {
    for (int seed = 1; seed <= 20; ++seed) {
        Random random(static_cast<std::uint64_t>(seed));
        PointSet points;
        for (int i = 0; i < 400; ++i) points.position.push_back(10.0 * random.inCube());
        std::vector<MeshFailure> failures;
        for (int i = 0; i < 120; ++i) {
            std::set<Index> corners;
            const auto first = static_cast<Index>(random.below(398));
            for (Index k = 0; k <= static_cast<Index>(i % 3); ++k) corners.insert(first + k);
            failures.push_back(failureAt("second_layers", {corners.begin(), corners.end()}));
        }
        const double meanEdge = 0.1 + 0.02 * seed;
        DisjointSets joined(failures.size());
        for (Index a = 0; a < failures.size(); ++a) {
            for (Index b = 0; b < a; ++b) {
                for (const Index p : failures[a].points) {
                    for (const Index q : failures[b].points) {
                        if (glm::distance(points.position[p], points.position[q]) < 3.0 * meanEdge)
                            joined.unite(a, b);
                    }
                }
            }
        }
        std::set<Positions> expected;
        for (Index least = 0; least < failures.size(); ++least) {
            Positions set;
            for (Index a = 0; a < failures.size(); ++a) {
                if (joined.find(a) == least) set.push_back(a);
            }
            if (!set.empty()) expected.insert(set);
        }
        std::set<Positions> found;
        for (FaultPlace& place : faultPlaces(points, failures, meanEdge)) {
            std::sort(place.faults.begin(), place.faults.end());
            found.insert(place.faults);
        }
        CHECK(found == expected);
        CHECK(found.size() > 1);
    }
}

TEST_CASE("places: none without faults, and one for a mesh of points in one place") {
    const PointSet points = alongX({1, 1});
    CHECK(faultPlaces(points, {}, 1.0).empty());
    const std::vector<MeshFailure> openings{failureAt("openings", {0, 1}, 4.0)};
    CHECK(faultPlaces(points, openings, 1.0).empty());
    const std::vector<MeshFailure> two{failureAt("degenerate_triangles", {0}),
                                       failureAt("degenerate_triangles", {1})};
    CHECK(faultPlaces(points, two, 0.0).size() == 1);
}

TEST_CASE("places: a hole is described by its edges, several by those of the longest") {
    PointSet points = alongX({0, 1, 2, 3});
    MeshFailure small = failureAt("holes", {0, 1, 2}, 3.0);
    small.triangles = {0, 1, 2};
    MeshFailure large = failureAt("holes", {1, 2, 3}, 9.0);
    large.triangles = {0, 1, 2, 3, 4};
    std::vector<MeshFailure> failures{small};
    CHECK(describe(faultPlaces(points, failures, 1.0)[0], failures) == "1 hole of 3 edges");
    failures.push_back(large);
    failures.push_back(failureAt("non_manifold_vertices", {0}));
    failures.push_back(failureAt("non_manifold_vertices", {1}));
    CHECK(describe(faultPlaces(points, failures, 1.0)[0], failures) ==
          "2 holes of up to 5 edges, 2 non-manifold vertices");
}
