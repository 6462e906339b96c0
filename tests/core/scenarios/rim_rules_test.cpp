/// Rim points under the rules: section 7 and `fill`, for boundary points without wall bits.
#include <doctest/doctest.h>

#include "spiraling_edge/mesh/faults.h"
#include "spiraling_edge/stepper/rules.h"
#include "support/open_surfaces.h"
#include "support/random_points.h"

using namespace se;
using namespace se::test;

TEST_CASE("7 rim: what is left of a sector beside the gap") {
    struct Case {
        double first, last;
        bool same;
        RimSector sector;
    };
    // The gap runs from 180 to 360 degrees.
    const Case cases[] = {
        {0, 180, false, {false, false, false}},  {30, 100, false, {false, false, false}},
        {180, 0, false, {true, false, false}},   {150, 0, false, {true, true, false}},
        {180, 40, false, {true, false, true}},   {150, 40, false, {true, true, true}},
        {200, 300, false, {true, false, false}}, {300, 350, false, {true, false, false}},
        {300, 90, false, {true, false, true}},   {90, 220, false, {true, true, false}},
        {90, 90, true, {true, true, true}}};
    for (const Case& c : cases) {
        for (const double turn : {0.0, 77.0, 201.0}) {
            CAPTURE(c.first);
            CAPTURE(c.last);
            const RimSector sector = testRimSector(
                Vec3(0), Vec3(0, 0, 1), polar(c.first + turn, 2.0), polar(c.last + turn, 0.7),
                c.same, polar(180 + turn), polar(360 + turn, 1.3));
            CHECK(sector.holdsGap == c.sector.holdsGap);
            CHECK(sector.openAtFirst == c.sector.openAtFirst);
            CHECK(sector.openAtLast == c.sector.openAtLast);
        }
    }
}

namespace {

/// A run with these rules, with rims known.
struct RimRun {
    MeshReport mesh;
    std::string faults;
    std::size_t triangleFaults;
    std::uint32_t holes;  ///< Rings freed with interior points: an alert each.
};
RimRun runWithRim(const PointFile& file, const std::string& rules) {
    const Prepared prepared = withRim(file);
    const Run run = runAll(prepared.points, *paramsByName(rules));
    const std::vector<Triangle>& mesh = run.state.mesh();
    return {run.mesh, describeFaults(prepared.points, mesh),
            findFaults(prepared.points, mesh).size(), run.state.counters.holes};
}

}  // namespace

TEST_CASE("rim: openings stay open, without an alert, by the rules of the paper too") {
    for (const std::string rules : {"paper", "corrected"}) {
        std::size_t faulty = 0;
        for (const Open& open : openSurfaces()) {
            if (open.spacing == 1.0) continue;  // Lattices have ties, which only robust handles.
            CAPTURE(rules);
            CAPTURE(open.name);
            const RimRun outcome = runWithRim(open.file, rules);
            CHECK(outcome.mesh.boundaryLoops == open.rims);
            CHECK(outcome.holes == 0);
            faulty += outcome.triangleFaults == 0 ? 0U : 1U;
        }
        CHECK(faulty == 0);
    }
}

TEST_CASE("rim: by the robust rules the rim is clean, and no point is left out") {
    for (const Open& open : openSurfaces()) {
        CAPTURE(open.name);
        const RimRun outcome = runWithRim(open.file, "robust");
        CHECK(outcome.faults == "");
        CHECK(outcome.mesh.boundaryLoops == open.rims);
        CHECK(outcome.mesh.unusedPoints == 0);
        CHECK(outcome.mesh.nonManifoldVertices == 0);
        CHECK(outcome.holes == 0);
    }
}

TEST_CASE("rim: strips that are all rim are meshed from end to end") {
    PointFile strip;
    for (int i = 0; i < 12; ++i) {
        add(strip, Vec3(i, 0, 0), Vec3(0, 0, 1));
        add(strip, Vec3(i + 0.5, 0.87, 0), Vec3(0, 0, 1));
    }
    strip.type.assign(strip.position.size(), kRimPoint);
    const Run run = runAll(prepared(strip), Params{});
    CHECK(run.mesh.triangles == 22);
    CHECK(run.mesh.boundaryLoops == 1);
    CHECK(run.mesh.unusedPoints == 0);
}

TEST_CASE("rim: an oriented manifold from random points with rim points and gaps by chance") {
    const Params robust = *paramsByName("robust");
    for (std::uint64_t seed = 1; seed <= 200; ++seed) {
        PointSet points = randomPoints(seed);
        Random random(seed);
        points.rim.resize(points.size());
        for (Index p = 0; p < points.size(); ++p) {
            const auto list = points.neighbors[p];
            if (list.size() < 2 || isOnWall(points.type[p]) || random.below(2) == 0) continue;
            points.type[p] = kRimPoint;
            if (random.below(8) > 0)
                points.rim[p] = {list[random.below(list.size())], list[random.below(list.size())]};
        }
        REQUIRE(validate(points).ok());
        CHECK_MESSAGE(firstBreach(points, robust, InvariantChecker::Level::Guarded) == "", "seed ",
                      seed);
        CHECK_MESSAGE(firstBreach(points, Params{}, InvariantChecker::Level::AnyInput) == "",
                      "seed ", seed);
    }
}
