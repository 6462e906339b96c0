#include "spiraling_edge/run/reading.h"

#include <doctest/doctest.h>

#include <string>

#include "support/clouds.h"
#include "support/oracles.h"
#include "support/rule_values.h"

using namespace se;
using namespace se::test;

namespace {

/// Pivot 0 at the origin, the others at one unit from it.
PointSet four() {
    PointSet points;
    points.position = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}};
    return points;
}
Reading reading(const Evidence& evidence) {
    const PointSet points = four();
    const Params params = paper();
    const auto found = readingOf({{1, Stage::Sort, 1}, evidence}, {points, params, 0});
    REQUIRE(found.has_value());
    return *found;
}
double inDegrees(double radians) { return radians * 180.0 / kPi; }

/// Checks the sign of each margin in a run of a scene. Returns the number of margins that are not
/// 0.
int checkSigns(const Scene& scene, Params params) {
    CAPTURE(scene.id);
    params = withStartOf(scene, params);
    const SharedPoints points = turnedPoints(sceneNamed(scene.id), params);
    int checked = 0;
    Index pivot = kNone;
    for (const Event& event : eventsOf(sceneNamed(scene.id), params)) {
        if (const auto* begun = as<PivotEvidence>(event)) pivot = begun->pivot;
        const auto reading = readingOf(event, {*points, params, pivot});
        if (!reading || reading->margin == 0.0) continue;
        CAPTURE(toString(event.address));
        CHECK((reading->margin > 0.0) == (outcomeOf(event) == Outcome::Taken));
        ++checked;
    }
    return checked;
}

}  // namespace

TEST_CASE("reading: the margin of an angle in a sector is that to the nearer limit") {
    const auto margin = [](double degrees, Verdict verdict) {
        const Reading at = reading(SortEvidence{1, 0.0, false, degrees, 100.0, verdict, kNone});
        CHECK(at.value - at.threshold ==
              doctest::Approx(at.threshold > 0 ? degrees - 100.0
                                               : (degrees > 180 ? degrees - 360.0 : degrees)));
        return inDegrees(at.margin);
    };
    CHECK(margin(10, Verdict::Kept) == doctest::Approx(10));
    CHECK(margin(95, Verdict::Kept) == doctest::Approx(5));
    CHECK(margin(110, Verdict::NotBeforeEnd) == doctest::Approx(-10));
    CHECK(margin(355, Verdict::NotBeforeEnd) == doctest::Approx(-5));
}

TEST_CASE("reading: a point is on the side of the plane where the pivot is, or beyond") {
    for (const double pivot : {0.7, -0.7}) {
        const double toward = pivot > 0 ? 1.0 : -1.0;
        const auto margin = [&](double side, Verdict verdict) {
            return reading(HoleEvidence{1, Vec3(0, 2, 0), side, pivot, verdict}).margin;
        };
        CHECK(margin(0.2 * toward, Verdict::Kept) > 0.0);
        CHECK(margin(-0.2 * toward, Verdict::FarSide) < 0.0);
    }
}

TEST_CASE("reading: of the two tests of 6.3 the one that decides has the margin") {
    const auto of = [](double radius, double distance, double gap, Verdict verdict) {
        return reading(SphereEvidence{2, 1, 3, Vec3(0.0), radius, distance, gap, verdict});
    };
    // Inside by 0.1 of the distance from the pivot, the gap far below 120 degrees.
    CHECK(of(0.6, 0.5, 60, Verdict::InsideSphere).margin == doctest::Approx(0.1));
    // Outside, and kept for the gap.
    const Reading gap = of(0.5, 0.9, 150, Verdict::GapTooWide);
    CHECK(gap.quantity == "gap");
    CHECK(inDegrees(gap.margin) == doctest::Approx(30));
    // Removed: the nearer of the two.
    CHECK(of(0.5, 0.6, 60, Verdict::Removed).margin == doctest::Approx(-0.1));
    CHECK(inDegrees(of(0.5, 2.0, 119, Verdict::Removed).margin) == doctest::Approx(-1));
}

TEST_CASE("reading: a point that is DONE, or an end of the sector, was settled before") {
    const auto settled = [](Verdict verdict) {
        return wasSettledBefore(
            {{1, Stage::Sort, 1}, SortEvidence{1, 0.0, false, 10, 100, verdict, kNone}});
    };
    CHECK(settled(Verdict::AlreadyDone));
    CHECK(settled(Verdict::OnRingEnd));
    CHECK_FALSE(settled(Verdict::NotBeforeEnd));
    CHECK_FALSE(settled(Verdict::SameAngle));
}

TEST_CASE("reading: a margin is above 0 where the point is taken, below 0 where it is not") {
    int checked = 0;
    for (const std::string rules : {"paper", "printed", "corrected", "robust"}) {
        CAPTURE(rules);
        forEachScene(
            [&](const Scene& scene) { checked += checkSigns(scene, *paramsByName(rules)); });
    }
    CHECK(checked > 100000);
}

TEST_CASE("reading: a margin has the sign of the outcome by every value of a rule" *
          doctest::test_suite("long")) {
    forEachPaperRule(paper(), [](const Params& params, const std::string& rule) {
        CAPTURE(rule);
        for (const char* id : {"four-edge-hole", "figure-14", "close-sheets", "grid", "torus"})
            checkSigns(*findScene(id), params);
    });
}

TEST_CASE("reading: a pivot on the plane of a hole has no side to be on") {
    const PointSet points = four();
    const Params params = paper();
    const Event event{{1, Stage::Hole, 1},
                      HoleEvidence{1, Vec3(0, 2, 0), 0.3, 0.0, Verdict::FarSide}};
    CHECK_FALSE(readingOf(event, {points, params, 0}).has_value());
}
