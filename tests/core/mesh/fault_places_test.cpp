#include "spiraling_edge/mesh/fault_places.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <set>

#include "support/clouds.h"
#include "support/oracles.h"

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

TEST_CASE("places: a fault with all less severe ones nearer than three mean edges, or connected") {
    const PointSet points = alongX({0, 2.9, 5.7, 100, 200, 202.9});
    const std::vector<MeshFailure> failures{
        failureAt("lost_points", {0}), failureAt("lost_points", {1}), failureAt("lost_points", {2}),
        failureAt("folded_edges", {3, 4}), failureAt("flipped_triangles", {5})};
    const auto places = faultPlaces(points, failures, 1.0);
    REQUIRE(places.size() == 3);
    CHECK(places[0].faults == Positions{0, 1});
    // Near the second fault, but not near the first one of its place.
    CHECK(places[1].faults == Positions{2});
    CHECK(places[2].faults == Positions{3, 4});
    CHECK(places[2].center == failures[3].place);
    CHECK(faultPlaces(points, failures, 0.9).size() == 5);
    CHECK(faultPlaces(points, failures, 2.0)[0].faults == Positions{0, 1, 2});
}

TEST_CASE("places: holes come first, the longest before the others, flipped triangles last") {
    const PointSet points = alongX({0, 100, 200, 300, 400, 410, 420});
    const std::vector<MeshFailure> failures{failureAt("flipped_triangles", {0}),
                                            failureAt("holes", {1}, 3.0),
                                            failureAt("holes", {2}, 5.0),
                                            failureAt("lost_points", {3}),
                                            failureAt("lost_points", {4}),
                                            failureAt("intersecting_triangles", {4, 5}),
                                            failureAt("slivers", {6})};
    const auto places = faultPlaces(points, failures, 1.0);
    std::vector<std::size_t> first;
    for (const FaultPlace& place : places) first.push_back(place.faults.front());
    // A sliver is no fault.
    CHECK(first == Positions{2, 1, 3, 4, 0});
    CHECK(describe(places[3], failures) == "1 lost point, 1 intersecting pair");
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
        const auto areNear = [&](const MeshFailure& a, const MeshFailure& b) {
            return std::any_of(a.points.begin(), a.points.end(), [&](Index p) {
                return std::any_of(b.points.begin(), b.points.end(), [&](Index q) {
                    return glm::distance(points.position[p], points.position[q]) < 3.0 * meanEdge;
                });
            });
        };
        std::vector<bool> placed(failures.size(), false);
        std::vector<Positions> expected;
        for (std::size_t a = 0; a < failures.size(); ++a) {
            if (placed[a]) continue;
            Positions place;
            for (std::size_t b = a; b < failures.size(); ++b) {
                if (placed[b] || !areNear(failures[a], failures[b])) continue;
                placed[b] = true;
                place.push_back(b);
            }
            expected.push_back(place);
        }
        std::vector<Positions> found;
        for (const FaultPlace& place : faultPlaces(points, failures, meanEdge))
            found.push_back(place.faults);
        CHECK(found == expected);
        CHECK(found.size() > 1);
    }
}

TEST_CASE("places: none without faults, and without edges only common points connect") {
    const PointSet points = alongX({1, 1});
    CHECK(faultPlaces(points, {}, 1.0).empty());
    const std::vector<MeshFailure> openings{failureAt("openings", {0, 1}, 4.0)};
    CHECK(faultPlaces(points, openings, 1.0).empty());
    const std::vector<MeshFailure> three{failureAt("degenerate_triangles", {0}),
                                         failureAt("degenerate_triangles", {1}),
                                         failureAt("degenerate_triangles", {0})};
    const auto places = faultPlaces(points, three, 0.0);
    REQUIRE(places.size() == 2);
    CHECK(places[0].faults == Positions{0, 2});
}

TEST_CASE("places: a hole is described by its edges, several by those of the longest") {
    const PointSet points = alongX({0, 1, 2, 3});
    // The hole of three edges has two of them on one triangle.
    MeshFailure small = failureAt("holes", {0, 1, 2}, 3.0);
    small.edges = {{0, 1}, {1, 2}, {0, 2}};
    small.triangles = {0, 1};
    MeshFailure large = failureAt("holes", {0, 1, 2, 3}, 9.0);
    large.edges = {{0, 1}, {1, 2}, {2, 3}, {0, 3}};
    std::vector<MeshFailure> failures{small};
    CHECK(describe(faultPlaces(points, failures, 1.0)[0], failures) == "1 hole of 3 edges");
    failures.push_back(large);
    failures.push_back(failureAt("non_manifold_vertices", {0}));
    failures.push_back(failureAt("non_manifold_vertices", {1}));
    CHECK(describe(faultPlaces(points, failures, 1.0)[0], failures) ==
          "2 holes of up to 4 edges, 2 non-manifold vertices");
    failures.push_back(failureAt("lost_points", {3}));
    failures.push_back(failureAt("folded_edges", {1, 2}));
    CHECK(describe(faultPlaces(points, failures, 1.0)[0], failures) ==
          "2 holes of up to 4 edges, 1 lost point, 2 non-manifold vertices, 1 other");
}
