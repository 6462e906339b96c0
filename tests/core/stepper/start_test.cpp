#include <doctest/doctest.h>

#include "support/clouds.h"
#include "support/oracles.h"
#include "support/rig.h"

using namespace se;
using namespace se::test;

namespace {

/// A hexagon around point 0, all listed by all.
std::vector<Vec3> hexagon(const Vec3& at = Vec3(0)) {
    std::vector<Vec3> position{at};
    for (int i = 0; i < 6; ++i) position.push_back(at + polar(60 * i, 1 + 0.01 * i));
    return position;
}

}  // namespace

TEST_CASE("4 before the start every point is UNUSED") {
    const State state(5);
    for (const PointStatus status : state.status) CHECK(status == kUnused);
    CHECK(state.startPointer == 0);
    CHECK(state.phase == Phase::Seed);
}

TEST_CASE("4 the edge ring begins with the first point not DONE and its nearest, both USED") {
    Rig rig(hexagon());
    rig.listAll();
    REQUIRE(rig.runTo(Phase::Pivot));
    CHECK(rig.activeRing() == Points{0, 1});  // The traversal begins with the first point.
    CHECK(rig.status(0) == 1);
    CHECK(rig.status(1) == 1);
    for (Index p = 2; p < 7; ++p) CHECK(rig.status(p) == kUnused);
}

TEST_CASE("4 DONE points are neither first nor nearest neighbor of a new ring") {
    Rig rig(hexagon());
    rig.listAll().done({0, 1, 2}).runTo(Phase::Pivot);
    CHECK(rig.state().startPointer == 3);
    CHECK(rig.activeRing() == Points{3, 4});
}

TEST_CASE("4 a point without neighbors is noise: DONE, and the search continues") {
    Rig rig(hexagon());
    rig.list(2, {3}).runTo(Phase::Pivot);
    CHECK(rig.status(0) == kDone);
    CHECK(rig.status(1) == kDone);
    CHECK(rig.state().counters.isolated == 2);
    CHECK(rig.activeRing() == Points{2, 3});
    CHECK(rig.all<StrandEvidence>()[0].isolated);
}

TEST_CASE("4 a point whose neighbors are all DONE is stranded: DONE, and the search continues") {
    Rig rig(hexagon());
    rig.list(0, {5, 6}).list(1, {2}).done({5, 6}).runTo(Phase::Pivot);
    CHECK(rig.status(0) == kDone);
    CHECK(rig.state().counters.stranded == 1);
    CHECK_FALSE(rig.all<StrandEvidence>()[0].isolated);
    CHECK(rig.activeRing() == Points{1, 2});
}

TEST_CASE("4 the start pointer only advances, and points before it are DONE at each new ring") {
    const PointSet points = prepared(closedFamilies(0.4)[2].sample(1));
    Stepper stepper(points, paper());
    Index before = 0;
    while (stepper.advance()) {
        const State& s = stepper.state();
        CHECK(s.startPointer >= before);
        if (s.phase == Phase::Pivot && s.startPointer != before) {
            for (Index p = 0; p < s.startPointer; ++p) CHECK(s.status[p] == kDone);
        }
        before = s.startPointer;
    }
    CHECK(before == points.size());
}

namespace {

/// Points 0 and 1 list each other alone, so that their seed gets no triangle; then a hexagon.
Rig& pairBeforeHexagon(Rig& rig) {
    rig.list(0, {1}).list(1, {0});
    for (Index p = 2; p < 9; ++p) {
        Points others;
        for (Index q = 2; q < 9; ++q) {
            if (q != p) others.push_back(q);
        }
        rig.list(p, others);
    }
    return rig;
}
std::vector<Vec3> pairAndHexagon() {
    std::vector<Vec3> position{{-9, 0, 0}, {-9, 1, 0}};
    for (const Vec3& x : hexagon()) position.push_back(x);
    return position;
}

}  // namespace

TEST_CASE("keepseeds: a seed without a triangle leaves both points UNUSED, the next is another") {
    Rig rig(pairAndHexagon());
    pairBeforeHexagon(rig).pivot().pivot();
    CHECK(rig.triangles().empty());
    CHECK(rig.status(0) == kUnused);
    CHECK(rig.status(1) == kUnused);
    CHECK(rig.state().startPointer == 1);
    CHECK(rig.all<FreeEvidence>().back().seed);
    rig.run();
    const auto seeds = rig.all<SeedEvidence>();
    REQUIRE(seeds.size() == 3);
    CHECK(seeds[1].first == 1);
    CHECK(seeds[2].first == 2);
    CHECK(rig.state().counters.failedSeeds == 2);
    // The first component that is complete is number 1.
    REQUIRE(rig.all<ComponentEvidence>().size() == 1);
    CHECK(rig.all<ComponentEvidence>()[0].component == 1);
}

TEST_CASE("keepseeds: what no seed and no ring took is stranded at the end, with the reason") {
    Rig rig(pairAndHexagon());
    pairBeforeHexagon(rig).run();
    const auto strands = rig.all<StrandEvidence>();
    REQUIRE(strands.size() == 2);
    for (const StrandEvidence& each : strands) {
        CHECK(each.point < 2);
        CHECK(each.unseeded);
        CHECK_FALSE(each.isolated);
        CHECK(rig.status(each.point) == kDone);
    }
    CHECK(rig.state().counters.stranded == 2);
    CHECK(rig.state().counters.lostSeeds == 0);
    for (const Alert& alert : rig.state().alerts) CHECK(alert.kind != AlertKind::LostSeed);
}

TEST_CASE("keepseeds off: the points of a seed without a triangle are DONE, with an alert") {
    Rig rig(pairAndHexagon(), paperBut(&Readings::keepSeeds));
    pairBeforeHexagon(rig).pivot().pivot();
    CHECK(rig.status(0) == kDone);
    CHECK(rig.status(1) == kDone);
    CHECK(rig.state().counters.lostSeeds == 1);
    CHECK(rig.state().alerts.size() == 1);
    CHECK_FALSE(rig.all<FreeEvidence>().back().seed);
    CHECK_FALSE(printed().readings.keepSeeds);
}

TEST_CASE("keepseeds: each point begins at most one ring in vain, so that every run ends") {
    // Pairs far apart from each other: no seed gets a triangle.
    std::vector<Vec3> pairs;
    for (int i = 0; i < 200; ++i) pairs.push_back({9.0 * (i / 2), i % 2, 0});
    for (const Params& params : {paper(), robust()}) {
        Rig rig(pairs, params);
        for (Index p = 0; p < 200; ++p) rig.list(p, {p ^ 1U});
        rig.run();
        CHECK(rig.state().finished());
        std::vector<int> begun(200, 0);
        for (const SeedEvidence& each : rig.all<SeedEvidence>()) ++begun[each.first];
        CHECK(*std::max_element(begun.begin(), begun.end()) == 1);
        CHECK(rig.state().counters.stranded == 200);
    }
}

TEST_CASE("3 a new ring is begun for each component, when the ring and the stack are empty") {
    std::vector<Vec3> two = hexagon();
    for (const Vec3& x : hexagon(Vec3(50, 0, 0))) two.push_back(x);
    Rig rig(two);
    for (const Index base : {0U, 7U}) {
        for (Index p = 0; p < 7; ++p) {
            Points others;
            for (Index q = 0; q < 7; ++q) {
                if (q != p) others.push_back(base + q);
            }
            rig.list(base + p, others);
        }
    }
    rig.run();
    CHECK(rig.state().counters.seeds == 2);
    CHECK(rig.all<SeedEvidence>()[1].first == 7);
    const MeshReport mesh = reportMesh(rig.points(), rig.triangles());
    CHECK(mesh.components == 2);
}

TEST_CASE("3 a stacked ring is finished before a new ring is begun") {
    Rig rig({{0, 0, 0}, {1, 1, 0}, {-1, 1, 0}, {9, 0, 0}, {10, 1, 0}, {8, 1, 0}, {20, 0, 0}});
    rig.list(0, {1, 2}).list(3, {4, 5}).stacked({3, 5, 4}).ring({0, 2, 1}).pivot();
    CHECK(rig.triangles() == Triangles{{0, 1, 2}});
    CHECK(rig.state().counters.seeds == 0);
    CHECK(rig.activeRing() == Points{3, 5, 4});
    rig.pivot();
    CHECK(rig.triangles().back() == Triangle{3, 4, 5});
    rig.run();
    CHECK(rig.status(6) == kDone);
    CHECK(rig.state().counters.isolated == 1);
}

TEST_CASE("3 when the run ends no point is UNUSED") {
    for (const auto& family : closedFamilies(0.3)) {
        const Run run = runAll(prepared(family.sample(3)), paper());
        for (const PointStatus status : run.state.status) CHECK(status == kDone);
        CHECK(run.state.finished());
    }
}

TEST_CASE("5 first and last are the points before and after the pivot on the ring") {
    Rig rig(hexagon());
    rig.listAll().ring({0, 3, 4, 5, 2}).runTo(Phase::Sort);
    const NeighborRing& n = rig.state().pivot;
    CHECK(rig.state().rings.point(n.first) == 2);
    CHECK(rig.state().rings.point(n.last) == 3);
    CHECK(n.start == n.first);
    CHECK(n.end == n.last);
    Rig seed(hexagon());
    seed.listAll().runTo(Phase::Sort);
    CHECK(seed.state().pivot.first == seed.state().pivot.last);
}

TEST_CASE("an empty set of points is finished at once") {
    const Run run = runAll(PointSet{}, paper());
    CHECK(run.state.finished());
    CHECK(run.state.triangles.empty());
    CHECK(run.state.counters == Counters{});
}
