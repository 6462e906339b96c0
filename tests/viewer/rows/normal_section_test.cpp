#include "rows/normal_section.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "drawn.h"

using namespace se;
using namespace se::view;
using namespace se::view::test;

namespace {

NormalSection sectionAt(OpenSession& open, const char* address, double turnDegrees = 0.0) {
    open.session.moves().goToText(address);
    open.session.waitUntilDone();
    const DecisionState& picture = open.session.picture();
    return makeSection(open.session.model(), picture,
                       std::span(open.session.triangles()).first(picture.finishedTriangles),
                       turnDegrees);
}

const SectionPoint* pointOf(const NormalSection& section, Index point) {
    const auto found = std::find_if(section.points.begin(), section.points.end(),
                                    [&](const SectionPoint& p) { return p.point == point; });
    return found == section.points.end() ? nullptr : &*found;
}

constexpr const char* kTested = "137.sphere.3";

}  // namespace

TEST_CASE("Section: the pivot, its normal and the tested point are in the plane") {
    OpenSession open("scene:torus");
    const NormalSection section = sectionAt(open, kTested);
    const PointSet& points = open.session.model().points;
    REQUIRE_FALSE(section.empty());
    CHECK(section.through == open.session.picture().underTest);
    const SectionPoint* tested = pointOf(section, section.through);
    REQUIRE(tested != nullptr);
    CHECK(tested->underTest);
    CHECK(std::abs(tested->off) < 1e-12);
    CHECK(tested->at.x > 0.0);
    const Vec3 offset = points.position[tested->point] - points.position[section.pivot];
    CHECK(tested->at.y == doctest::Approx(glm::dot(offset, points.normal[section.pivot])));
}

TEST_CASE("Section: distances in it are true distances, and feet are that far from the points") {
    OpenSession open("scene:torus");
    const PointSet& points = open.session.model().points;
    for (const double turn : {0.0, 15.0, -100.0}) {
        CAPTURE(turn);
        const NormalSection section = sectionAt(open, kTested, turn);
        REQUIRE(section.points.size() > 3);
        for (const SectionPoint& point : section.points) {
            const double inPlane = glm::length(point.at);
            CHECK(std::hypot(inPlane, point.off) ==
                  doctest::Approx(
                      glm::distance(points.position[point.point], points.position[section.pivot])));
        }
    }
}

TEST_CASE("Section: a turn keeps heights, and turns the tested point out of the plane") {
    OpenSession open("scene:torus");
    const NormalSection straight = sectionAt(open, kTested);
    const NormalSection turned = sectionAt(open, kTested, 30.0);
    const SectionPoint* before = pointOf(straight, straight.through);
    const SectionPoint* after = pointOf(turned, straight.through);
    REQUIRE(before != nullptr);
    REQUIRE(after != nullptr);
    CHECK(after->at.y == doctest::Approx(before->at.y));
    CHECK(after->at.x == doctest::Approx(before->at.x * std::sqrt(0.75)));
    CHECK(std::abs(after->off) == doctest::Approx(0.5 * before->at.x));
}

TEST_CASE("Section: the tested point is inside the circle exactly if it is inside the sphere") {
    OpenSession open("scene:torus");
    int inside = 0;
    int outside = 0;
    for (std::uint32_t pivot = 100; pivot < 130; ++pivot) {
        const std::string address = std::to_string(pivot) + ".sphere.1";
        const NormalSection section = sectionAt(open, address.c_str());
        const DecisionState& picture = open.session.picture();
        const auto* test = picture.evidence<SphereEvidence>(Stage::Sphere);
        if (test == nullptr || picture.event->address.stage != Stage::Sphere) continue;
        CAPTURE(address);
        REQUIRE(section.circle);
        CHECK(section.circle->radius <= test->radius);
        // The pivot is on the sphere.
        CHECK(glm::length(section.circle->center) == doctest::Approx(section.circle->radius));
        const SectionPoint* q = pointOf(section, test->q);
        REQUIRE(q != nullptr);
        const bool within = glm::distance(q->at, section.circle->center) < section.circle->radius;
        CHECK(within == (test->distance < test->radius));
        within ? ++inside : ++outside;
    }
    CHECK(inside > 0);
    CHECK(outside > 0);
}

TEST_CASE("Section: cuts are in the plane and as long as on the triangles") {
    OpenSession open("scene:torus");
    const NormalSection section = sectionAt(open, "300.emit.2");
    REQUIRE(section.cuts.size() > 4);
    CHECK(std::any_of(section.cuts.begin(), section.cuts.end(),
                      [](const SectionCut& cut) { return cut.isNew; }));
    // The plane contains the pivot: the surface passes through the middle of the section.
    const auto nearest = [&](const SectionCut& cut) {
        return std::min(glm::length(cut.from), glm::length(cut.to));
    };
    const auto closest = std::min_element(
        section.cuts.begin(), section.cuts.end(),
        [&](const SectionCut& a, const SectionCut& b) { return nearest(a) < nearest(b); });
    CHECK(nearest(*closest) < 1e-9);
}

TEST_CASE("Section: the second of two close sheets is beside the pivot's, at its true height") {
    OpenSession open("scene:close-sheets");
    const NormalSection section = sectionAt(open, "86.sort.2");
    REQUIRE_FALSE(section.empty());
    double highest = 0.0;
    for (const SectionPoint& point : section.points)
        highest = std::max(highest, std::abs(point.at.y));
    CHECK(highest > 0.08);
}

TEST_CASE("Section: none without a pivot") {
    OpenSession open("scene:sphere");
    CHECK(makeSection(open.session.model(), DecisionState{}, {}, 0.0).empty());
}
