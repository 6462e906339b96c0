#include "spiraling_edge/why/origin_decisions.h"

#include <doctest/doctest.h>

#include "support/rig.h"

using namespace se;
using namespace se::test;

namespace {

LedgerLine taken(const char* address, Index point) {
    const SortEvidence sort{point, 0.5, false, 60.0, 300.0, Verdict::Kept, kNone};
    return {{*addressFromString(address), sort}, 5, LineRole::Taken, {}};
}

/// The removal of `q` from between `t` and `s`.
LedgerLine removed(const char* address, Index t, Index q, Index s) {
    const SphereEvidence sphere{t, q, s, Vec3(0), 1.0, 2.0, 60.0, Verdict::Removed};
    return {{*addressFromString(address), sphere}, 5, LineRole::Refused, {}};
}

std::string addressOf(const std::optional<LedgerLine>& line) {
    return line ? toString(line->event.address) : "none";
}

/// The corners of a regular tetrahedron, each of which lists the others.
PointSet regularTetrahedron() {
    PointSet points;
    points.position = {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};
    for (const Vec3& x : points.position) points.normal.push_back(x / glm::length(x));
    points.type.assign(4, kInterior);
    for (const Points& list : std::vector<Points>{{1, 2, 3}, {0, 2, 3}, {0, 1, 3}, {0, 1, 2}})
        points.neighbors.append(list);
    return points;
}

}  // namespace

TEST_CASE("origin: a removal decides only for the triangle with both points beside the gap") {
    for (const auto& [t, s] : {std::pair<Index, Index>{6, 9}, {9, 6}}) {
        const std::vector<LedgerLine> decided{taken("1.sort.1", 6), removed("1.sphere.1", t, 8, s)};
        CHECK(addressOf(lastDecision(decided, Triangle{5, 6, 7})) == "1.sort.1");
        CHECK(addressOf(lastDecision(decided, Triangle{5, 6, 9})) == "1.sphere.1");
        CHECK(addressOf(lastDecision(decided, Triangle{5, 9, 7})) == "none");
        // The same for an edge.
        CHECK(addressOf(lastDecision(decided, 6, 7)) == "1.sort.1");
        CHECK(addressOf(lastDecision(decided, 6, 9)) == "1.sphere.1");
    }
}

TEST_CASE("origin: a triangle that fills a gap comes from the decision that made its last edge") {
    // Pivot 1 makes three triangles at 0, taking 2 and then 3; the last one is a gap of three.
    const PointSet points = regularTetrahedron();
    REQUIRE(validate(points).ok());
    Stepper stepper(points, paper());
    stepper.run();
    CHECK(stepper.state().mesh() == Triangles{{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}});
    const Points asked{1, 3};
    const auto origins = originDecisions(points, paper(), asked);
    REQUIRE(origins.has_value());
    REQUIRE(origins->size() == 2);
    // Of the edges 1-2 and 1-3, the later one came with the triangle for which 3 was taken.
    CHECK(toString(origins->at(3).event.address) == "1.sphere.2");
    CHECK(testedPoint(origins->at(3).event) == 3);
    CHECK(origins->at(3).pivot == 0);
    CHECK(toString(origins->at(1).event.address) == "1.sphere.2");
    CHECK_FALSE(originDecisions(points, paper(), asked, [](double) { return false; }).has_value());
}
