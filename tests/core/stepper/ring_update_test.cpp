#include <doctest/doctest.h>

#include "support/clouds.h"
#include "support/oracles.h"
#include "support/rig.h"

using namespace se;
using namespace se::test;

namespace {

/// Figure 11: as Figure 4, p = 0 in a bay; first = 1 is also on a stacked ring with 10 and 11.
std::vector<Vec3> doubledBay() {
    return {{0, 0, 0},      {1, 0.2, 0},   {-1, 0.2, 0},   {-9, -9, 0}, {9, -9, 0}, {1.1, 1.2, 0},
            {-1.1, 1.2, 0}, {0.3, 1.2, 0}, {-0.3, 1.2, 0}, {0, 20, 0},  {20, 1, 0}, {20, 2, 0}};
}

/// p = 0 faces north; e = 5 is there between 6 (before) and 7, with p in its free sector.
std::vector<Vec3> oppositeEntry() {
    return {{0, 0, 0}, {1, 0, 0},      {-1, 0, 0},    {-9, -9, 0}, {9, -9, 0},
            {0, 1, 0}, {-0.7, 1.7, 0}, {0.7, 1.7, 0}, {0, 3, 0}};
}

}  // namespace

TEST_CASE("6.5 Figure 11: the pivot, points before start and after end leave, the rest enters") {
    Rig rig(doubledBay());
    rig.list(0, {5, 6, 7, 8}).stacked({1, 10, 11}).ring({0, 2, 6, 3, 4, 5, 1}).pivot();
    CHECK(rig.status(0) == kDone);
    CHECK(rig.state().rings.firstEntryOf(0) == kNone);
    CHECK(rig.status(1) == 1);      // first: it was on two rings.
    CHECK(rig.status(2) == kDone);  // last: now surrounded.
    CHECK(rig.stackedRing() == Points{1, 10, 11});
    // Counterclockwise between start and end, from the end on, which is the new pivot.
    CHECK(rig.activeRing() == Points{6, 3, 4, 5, 7, 8});
    for (const Index p : {5U, 6U, 7U, 8U}) CHECK(rig.status(p) == 1);
}

TEST_CASE("6.5 a pivot with two entries loses one and stays USED") {
    Rig rig(doubledBay());
    rig.list(0, {7}).stacked({0, 10, 11}).ring({0, 2, 6, 3, 4, 5, 1}).pivot();
    CHECK(rig.triangles() == Triangles{{0, 1, 7}, {0, 7, 2}});
    CHECK(rig.status(0) == 1);
    CHECK(rig.stackedRing() == Points{0, 10, 11});
    CHECK(rig.activeRing()[0] == 2);  // End did not move: last is the new pivot.
}

TEST_CASE("6.4 without triangles the next point on the ring becomes the pivot") {
    Rig rig({{0, 0, 0}, polar(0), polar(200), {-9, -9, 0}, {9, -9, 0}});
    rig.list(0, {1, 2}).ring({0, 2, 3, 4, 1}).pivot();
    CHECK(rig.activeRing() == Points{2, 3, 4, 1, 0});
    CHECK(rig.state().circuit == 1);
}

TEST_CASE("6.5 a point met again in the active ring splits it in two, and one is stacked") {
    Rig rig(oppositeEntry());
    rig.list(0, {5}).ring({0, 2, 3, 6, 5, 7, 4, 1}).pivot();
    CHECK(rig.triangles() == Triangles{{0, 1, 5}, {0, 5, 2}});
    CHECK(rig.status(5) == 2);
    CHECK(rig.state().counters.splits == 1);
    CHECK(rig.activeRing() == Points{2, 3, 6, 5});  // The part with the next pivot.
    CHECK(rig.stackedRing() == Points{5, 7, 4, 1});
}

TEST_CASE("6.5 a ring taken from the stack goes on at the point where it was split off") {
    Rig rig(oppositeEntry());
    rig.list(0, {5}).ring({0, 2, 3, 6, 5, 7, 4, 1}).run();
    for (const AdvanceEvidence& each : rig.all<AdvanceEvidence>()) {
        if (!each.popped) continue;
        CHECK(each.to == 5);
        return;
    }
    FAIL("no ring was taken from the stack");
}

TEST_CASE("6.5 as printed the first other instance along the ring is taken, whatever its sector") {
    // 5 is on the ring twice: first with p behind it, then with p in its free sector.
    const std::vector<Vec3> position = [] {
        std::vector<Vec3> all = oppositeEntry();
        all.insert(all.end(), {{-3, 1, 0}, {-3, 4, 0}});  // 9, 10
        return all;
    }();
    const auto active = [&](InstanceRule rule) {
        Params params = paper();
        params.paper.instance = rule;
        Rig rig(position, params);
        rig.list(0, {5}).ring({0, 2, 9, 7, 5, 6, 10, 3, 6, 5, 7, 4, 1}).pivot();
        return rig.activeRing();
    };
    CHECK(active(InstanceRule::Sector) == Points{2, 9, 7, 5, 6, 10, 3, 6, 5});
    CHECK(active(InstanceRule::First) == Points{2, 9, 7, 5});
}

TEST_CASE("6.5 as printed the other instance is sought once the points before it are linked") {
    // 5 joins the stacked ring of the other entry of 8; for 8 that entry is then on the active
    // ring.
    Params params = paper();
    params.paper.instance = InstanceRule::First;
    params.paper.reciprocal = params.paper.sphere = false;
    params.readings.closeTwo = false;
    Rig rig({{0, 0, 0},
             {1, 0, 0},
             {-1, 0, 0},
             {-9, -9, 0},
             {9, -9, 0},
             {0.5, 1, 0},
             {0, 9, 0},
             {9, 9, 0},
             {-0.5, 1, 0}},
            params);
    rig.list(0, {5, 8}).stacked({5, 6, 8, 7}).stacked({8, 6, 7}).ring({0, 2, 3, 4, 1}).pivot();
    CHECK(rig.state().counters.joins == 1);
    CHECK(rig.state().counters.splits == 1);
    CHECK(rig.stackedRing(1) == Points{8, 6, 7});
}

TEST_CASE(
    "6.5 of the parts of a split the one with end stays active, or the longer, or the shorter") {
    std::vector<Vec3> position = oppositeEntry();
    position.push_back({0.9, 2.5, 0});
    const auto active = [&](ActiveRule rule) {
        Params params = paper();
        params.paper.active = rule;
        Rig rig(position, params);
        rig.list(0, {5}).ring({0, 2, 3, 6, 5, 7, 9, 4, 1}).pivot();
        REQUIRE(rig.state().counters.splits == 1);
        return rig.activeRing().size();
    };
    // End = 2 is in the part of 2, 3, 6 and 5; the other part is 5, 7, 9, 4, 1.
    CHECK(active(ActiveRule::End) == 4);
    CHECK(active(ActiveRule::Other) == 5);
    CHECK(active(ActiveRule::Longer) == 5);
    CHECK(active(ActiveRule::Shorter) == 4);
}

TEST_CASE(
    "6.5 Figure 12: a point met again in a stacked ring joins the two, standing twice in it") {
    Rig rig(oppositeEntry());
    rig.list(0, {5}).stacked({5, 7, 8, 6}).ring({0, 2, 3, 4, 1}).pivot();
    CHECK(rig.state().counters.joins == 1);
    CHECK(rig.state().rings.stack().empty());
    CHECK(rig.activeRing() == Points{2, 3, 4, 1, 5, 7, 8, 6, 5});
    CHECK(rig.status(5) == 2);
}

TEST_CASE("6.5 the stack is searched from the top: the most recent ring is joined") {
    Rig rig(oppositeEntry());
    rig.list(0, {5}).stacked({5, 7, 8, 6}).stacked({5, 7, 6}).ring({0, 2, 3, 4, 1}).pivot();
    CHECK(rig.activeRing() == Points{2, 3, 4, 1, 5, 7, 6, 5});
    CHECK(rig.stackedRing() == Points{5, 7, 8, 6});
    CHECK(rig.status(5) == 3);
    CHECK(rig.all<JoinEvidence>().at(0).depthFromTop == 0);
}

TEST_CASE("6.5 a joined ring leaves the stack wherever it was") {
    Rig rig(oppositeEntry());
    rig.list(0, {5}).stacked({5, 7, 6}).stacked({3, 4, 8}).ring({0, 2, 3, 4, 1}).pivot();
    CHECK(rig.all<JoinEvidence>().at(0).depthFromTop == 1);
    CHECK(rig.state().rings.stack().size() == 1);
    CHECK(rig.stackedRing() == Points{3, 4, 8});
}

TEST_CASE("6.5 a ring of two finished edges is closed: it is one edge inside the surface") {
    // 5 is beyond 1 on the ring, but too far around to be a limit: the point 1 and 5 both close.
    Rig rig({{0, 0, 0}, {1, 1, 0}, {-1, 1, 0}, {0, 2.2, 0}});
    rig.listAll().ring({0, 2, 3, 1}).pivot();
    CHECK(rig.state().counters.closedRings >= 1);
    CHECK(rig.state().rings.active() == kNone);
    Rig literal({{0, 0, 0}, {1, 1, 0}, {-1, 1, 0}}, paperBut(&Readings::closeTwo));
    literal.listAll().ring({0, 2, 1}).pivot();
    CHECK(literal.activeRing() == Points{2, 1});
    Rig closed({{0, 0, 0}, {1, 1, 0}, {-1, 1, 0}});
    closed.listAll().ring({0, 2, 1}).pivot();
    CHECK(closed.state().rings.active() == kNone);
    CHECK(closed.status(1) == kDone);
    CHECK(closed.status(2) == kDone);
}

namespace {

/// Before the pivot 0: a bay of 0, 5, 2 and 1, whose point 2 is also where the bay meets the rest
/// of the ring. Two triangles fill the bay, and 1 lies between the two entries of 2.
std::vector<Vec3> bayWithMouthPoint() {
    return {{0, 0, 0}, {-1, 1, 0}, {0, 2.2, 0}, {-2, 5, 0}, {2, 5, 0}, {1, 1, 0}};
}
const Points kBayOfFour{0, 1, 2, 3, 4, 2, 5};

/// Of each finished edge that was closed: its points, and how many are left on the ring.
std::vector<Points> closedBy(const Rig& rig) {
    std::vector<Points> all;
    for (const CloseEvidence& each : rig.all<CloseEvidence>())
        all.push_back({each.a, each.b, each.rest});
    return all;
}

}  // namespace

TEST_CASE("6.1, 6.5 an entry between two entries of one point is a finished edge, and is closed") {
    Rig rig(bayWithMouthPoint());
    rig.listAll().ring(kBayOfFour).pivot();
    CHECK(rig.triangles() == Triangles{{0, 5, 2}, {0, 2, 1}});
    CHECK(rig.activeRing() == Points{3, 4, 2});  // 1 and one entry of 2 are gone; 3 is next.
    CHECK(rig.status(1) == kDone);
    CHECK(rig.status(2) == 1);
    CHECK(closedBy(rig) == std::vector<Points>{{1, 2, 3}});
}

TEST_CASE("6.5 closing a finished edge also closes the one that becomes adjacent") {
    // Between the bay and the rest of the ring there are two points, 2 and 6, on two entries each.
    std::vector<Vec3> points = bayWithMouthPoint();
    points.push_back({0, 3.2, 0});
    Rig rig(points);
    rig.listAll().ring({0, 1, 2, 6, 3, 4, 6, 2, 5}).pivot();
    CHECK(rig.triangles() == Triangles{{0, 5, 2}, {0, 2, 1}});
    CHECK(rig.activeRing() == Points{3, 4, 6});
    for (const Index point : {1, 2}) CHECK(rig.status(point) == kDone);
    CHECK(closedBy(rig) == std::vector<Points>{{1, 2, 5}, {2, 6, 3}});
}

TEST_CASE("6.5 closing a finished edge also closes the one that begins where it ended") {
    // 2 stands on three entries, with 6 between two of them.
    std::vector<Vec3> points = bayWithMouthPoint();
    points.push_back({0, 3.2, 0});
    Rig rig(points);
    rig.listAll().ring({0, 1, 2, 6, 2, 3, 4, 2, 5}).pivot();
    CHECK(rig.triangles() == Triangles{{0, 5, 2}, {0, 2, 1}});
    CHECK(rig.activeRing() == Points{3, 4, 2});
    for (const Index point : {1, 6}) CHECK(rig.status(point) == kDone);
    CHECK(rig.status(2) == 1);
    CHECK(rig.all<CloseEvidence>().size() == 2);
}

TEST_CASE("6.5 where a finished edge goes, the step that is left is open if the one after it was") {
    for (const bool open : {false, true}) {
        Rig rig(bayWithMouthPoint());
        rig.listAll().ring(kBayOfFour);
        if (open) rig.open(2, 3);
        rig.pivot();
        CHECK(rig.activeRing() == Points{3, 4, 2});
        const EdgeRings& rings = rig.state().rings;
        CHECK(rings.open(rings.firstEntryOf(2)) == open);
    }
}

TEST_CASE(
    "6.5 a finished edge stays on the ring with one of its steps open, or with closetwo off") {
    for (const bool open : {false, true}) {
        Rig rig(bayWithMouthPoint(), open ? paper() : paperBut(&Readings::closeTwo));
        rig.listAll().ring(kBayOfFour);
        if (open) rig.open(1);
        rig.pivot();
        CHECK(rig.activeRing() == Points{1, 2, 3, 4, 2});
    }
}

TEST_CASE("6.1 the sector is a full turn where first and last are one point on two entries") {
    // Without the reading that closes such an edge: the paper's sentence, word for word.
    Rig rig({{0, 0, 0}, {1, 0, 0}, {5, 1, 0}, {5, -1, 0}, polar(120), polar(240)},
            paperBut(&Readings::closeTwo));
    rig.list(0, {1, 4, 5}).ring({0, 1, 2, 3, 1}).pivot();
    CHECK(rig.triangles() == Triangles{{0, 1, 4}, {0, 4, 5}, {0, 5, 1}});
    Rig alone({{0, 0, 0}, {1, 0, 0}, {5, 1, 0}, {5, -1, 0}}, paperBut(&Readings::closeTwo));
    alone.list(0, {1}).ring({0, 1, 2, 3, 1}).pivot();
    CHECK(alone.triangles().empty());
}

TEST_CASE("6.5 a single point inserted between two entries of one point is a finished edge") {
    // The step from the pivot is open, so that its sector is a full turn although both are 1.
    Rig rig({{0, 0, 0}, {1, 0, 0}, {5, 1, 0}, {5, -1, 0}, polar(120)});
    rig.list(0, {1, 4}).ring({0, 1, 2, 3, 1}).open(0).pivot();
    CHECK(rig.triangles() == Triangles{{0, 1, 4}, {0, 4, 1}});
    CHECK(rig.status(4) == kDone);
    CHECK(rig.activeRing() == Points{2, 3, 1});
}

TEST_CASE("7, 6.5 a ring of two with an open step is not finished") {
    Rig rig({{0, 0, 0}, {1, 1, 0}, {-1, 1, 0}});
    rig.listAll().ring({0, 2, 1}).open(2).pivot();
    CHECK(rig.activeRing() == Points{2, 1});
    CHECK(rig.status(1) == 1);
}

TEST_CASE(
    "6.5 where end is removed with a closed ring, the last inserted point that is left is next") {
    // 5 follows last = 2 on the ring, where it is convex; its other entry keeps it there. 8 lies
    // between first and 5.
    const Vec3 e(1.5, 0.5, 0);
    const std::vector<Vec3> position{{0, 0, 0},           polar(0), polar(200), {0, 9, 0},
                                     e + polar(198.7, 9), e,        {20, 1, 0}, {20, 2, 0},
                                     polar(9, 1.2)};
    for (const bool several : {false, true}) {
        Rig rig(position);
        rig.list(0, several ? Points{5, 8} : Points{5}).stacked({5, 6, 7}).ring({0, 2, 5, 4, 3, 1});
        rig.pivot();
        CHECK(rig.triangles() == (several ? Triangles{{0, 1, 8}, {0, 8, 5}, {0, 5, 2}}
                                          : Triangles{{0, 1, 5}, {0, 5, 2}}));
        CHECK(rig.state().counters.closedRings == 1);
        CHECK(rig.status(2) == kDone);
        CHECK(rig.activeRing() == (several ? Points{5, 4, 3, 1, 8} : Points{5, 4, 3, 1}));
    }
}

TEST_CASE("7 a freed ring with interior points is reported as a hole") {
    Rig rig({{0, 0, 0}, polar(0), polar(200), {-9, -9, 0}, {9, -9, 0}});
    rig.ring({0, 2, 3, 4, 1});
    for (int i = 0; i < 5; ++i) rig.pivot();
    // Without lists only ears under 180 degrees can close.
    rig.run();
    for (Index p = 0; p < 5; ++p) CHECK(rig.status(p) == kDone);
    CHECK(rig.state().finished());
}

TEST_CASE("7 a ring of two is a lost seed only if neither of its steps is an edge") {
    for (const bool first : {false, true}) {
        for (const bool second : {false, true}) {
            CAPTURE(first);
            CAPTURE(second);
            Rig rig({{0, 0, 0}, {1, 0, 0}}, paperBut(&Readings::keepSeeds));
            rig.ring({0, 1});
            if (first) rig.open(0);
            if (second) rig.open(1);
            rig.run();
            REQUIRE(rig.state().alerts.size() == 1);
            const bool lost = first && second;
            CHECK(rig.state().alerts[0].kind == (lost ? AlertKind::LostSeed : AlertKind::Hole));
            CHECK(rig.state().counters.lostSeeds == (lost ? 1 : 0));
            CHECK(rig.state().counters.holes == (lost ? 0 : 1));
        }
    }
}

TEST_CASE("6.5 status counts the entries, after every phase of a run") {
    const PointSet points = prepared(closedFamilies(0.35)[1].sample(1));
    Stepper stepper(points, paper());
    bool counted = true;
    do {
        const State& s = stepper.state();
        if (s.phase != Phase::Pivot && s.phase != Phase::Seed) continue;
        for (Index p = 0; p < points.size(); ++p) {
            PointStatus entries = 0;
            for (Index e = s.rings.firstEntryOf(p); e != kNone; e = s.rings[e].nextOfPoint) {
                ++entries;
            }
            counted = counted && std::max(s.status[p], 0) == entries;
        }
    } while (stepper.advance());
    CHECK(counted);
    CHECK(stepper.state().counters.splits > 0);
    CHECK(stepper.state().counters.joins > 0);
}

TEST_CASE("keepseeds: only a seed whose neighbors are all UNUSED leaves its points UNUSED") {
    for (const bool seed : {false, true}) {
        for (const bool finished : {false, true}) {
            CAPTURE(seed);
            CAPTURE(finished);
            Rig rig({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
            rig.rawList(0, {1}).rawList(1, {0, 2}).ring({0, 1}).open(0);
            if (finished) rig.done({2});
            if (seed) rig.open(1);
            rig.type(0, kNegativeX).type(1, kNegativeX);
            rig.pivot().pivot();
            const bool kept = seed && !finished;
            CHECK(rig.status(0) == (kept ? kUnused : kDone));
            CHECK(rig.status(1) == (kept ? kUnused : kDone));
            CHECK(rig.state().counters.failedSeeds == (kept ? 1 : 0));
            CHECK(rig.state().counters.freedRings == (kept ? 0 : 1));
            rig.run();
            for (Index p = 0; p < 2; ++p) CHECK(rig.status(p) == kDone);
        }
    }
}

// ---- beyond the paper: shelve -------------------------------------------------------------------

namespace {

/// A ring of 0, 1, 2, which list nothing, and two points that list each other.
std::vector<Vec3> ringAndSeed() { return {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {9, 0, 0}, {9, 1, 0}}; }

}  // namespace

TEST_CASE("shelve: a ring without a triangle waits until no seed is left, and is judged then") {
    Rig rig(ringAndSeed(), paperBut(&RobustRules::shelve));
    rig.list(3, {4}).list(4, {3}).ring({0, 1, 2}).pivot().pivot().pivot();
    CHECK(rig.state().rings.shelved() == 1);
    CHECK(rig.status(0) == 1);
    CHECK(rig.state().counters.freedRings == 0);
    rig.run();
    const auto shelved = rig.all<ShelveEvidence>();
    REQUIRE(shelved.size() == 1);  // The seeds of 3 and 4, without a triangle, are freed at once.
    CHECK(shelved[0].length == 3);
    REQUIRE(rig.all<TakeUpEvidence>().size() == 1);
    CHECK(rig.all<TakeUpEvidence>()[0].rings == 1);
    CHECK(rig.all<SeedEvidence>().size() == 2);
    const auto freed = rig.all<FreeEvidence>();
    REQUIRE(freed.size() == 3);
    CHECK(freed[0].length == 2);
    CHECK(freed[1].length == 2);
    CHECK(freed[2].length == 3);
    CHECK(rig.state().rings.shelved() == 0);
    CHECK(rig.state().finished());
}

TEST_CASE("shelve: without the rule the ring is freed before the next seed") {
    Rig rig(ringAndSeed());
    rig.list(3, {4}).list(4, {3}).ring({0, 1, 2}).run();
    CHECK(rig.all<ShelveEvidence>().empty());
    CHECK(rig.all<FreeEvidence>()[0].length == 3);
}

TEST_CASE("shelve: a point beside a shelved ring alone is no seed, and stranded at the end") {
    Rig rig(ringAndSeed(), paperBut(&RobustRules::shelve));
    rig.list(3, {0}).ring({0, 1, 2}).run();
    CHECK(rig.all<SeedEvidence>().empty());
    CHECK(rig.state().counters.stranded == 1);  // 3
    CHECK(rig.state().counters.isolated == 1);  // 4
    CHECK(rig.status(3) == kDone);
}

TEST_CASE("shelve: a point that waits for a shelved ring is DONE though the ring was joined") {
    // 3 lists only 0, on the shelved ring. The seed of 4 takes 0 into its fan, and with it the
    // shelved ring; no ring is left to be taken up, and none took 3.
    Rig rig({{0, 0, 0}, {-1, 1, 0}, {-1, -1, 0}, {0.5, 9, 0}, {2, 0, 0}, {3, 1, 0}, {3, -1, 0}},
            paperBut(&RobustRules::shelve));
    rig.list(3, {0}).list(4, {0, 5, 6}).list(5, {4}).list(6, {4}).ring({0, 1, 2}).run();
    REQUIRE(rig.all<ShelveEvidence>().size() >= 1);
    CHECK(rig.state().counters.joins == 1);
    CHECK(rig.all<ShelveEvidence>()[0].length == 3);
    CHECK(rig.all<SeedEvidence>().size() == 1);
    CHECK(rig.state().finished());
    for (Index p = 0; p < 7; ++p) CHECK(rig.status(p) == kDone);
    CHECK(rig.state().counters.stranded == 1);
}

TEST_CASE("shelve: a point beside a shelved ring is given up only after that ring was") {
    Rig rig(ringAndSeed(), paperBut(&RobustRules::shelve));
    rig.list(3, {0}).ring({0, 1, 2}).run();
    const auto place = [&](auto&& test) {
        const auto& events = rig.log().events();
        return std::find_if(events.begin(), events.end(), test) - events.begin();
    };
    const auto freed =
        place([](const Event& e) { return std::holds_alternative<FreeEvidence>(e.evidence); });
    const auto stranded = place([](const Event& e) {
        const auto* strand = std::get_if<StrandEvidence>(&e.evidence);
        return strand != nullptr && strand->point == 3;
    });
    CHECK(freed < stranded);
}

TEST_CASE("shelve: a seed's second point is UNUSED, even if one of a shelved ring is nearer") {
    Rig rig(ringAndSeed(), paperBut(&RobustRules::shelve));
    rig.rawList(3, {0, 4}).list(4, {3}).ring({0, 1, 2}).run();
    REQUIRE(rig.all<SeedEvidence>().size() == 1);
    CHECK(rig.all<SeedEvidence>()[0].first == 3);
    CHECK(rig.all<SeedEvidence>()[0].second == 4);
}

TEST_CASE("shelve: a component is done when no ring of it is left, on the stack or on the shelf") {
    Params params = paperBut(&Readings::keepSeeds);  // With it the seed is no component.
    Rig off(ringAndSeed(), params);
    params.robust.shelve = true;
    Rig rig(ringAndSeed(), params);
    rig.list(3, {4}).list(4, {3}).ring({0, 1, 2}).run();
    CHECK(rig.all<ComponentEvidence>().size() == 1);
    off.list(3, {4}).list(4, {3}).ring({0, 1, 2}).run();
    CHECK(off.all<ComponentEvidence>().size() == 2);
}

TEST_CASE("shelve: delayed fans are tried before a ring is put away") {
    Params params = paperBut(&RobustRules::shelve);
    params.robust.delay = true;
    Rig rig(ringAndSeed(), params);
    rig.ring({0, 1, 2}).pivot().pivot().pivot();
    CHECK(rig.state().rings.shelved() == 0);
    CHECK(rig.state().retryLevel == kDelayedAllowed);
    rig.pivot().pivot().pivot();
    CHECK(rig.state().rings.shelved() == 1);
}

TEST_CASE("delay: what a ring was allowed is not allowed to the next one") {
    Rig rig(ringAndSeed(), paperBut(&RobustRules::delay));
    rig.list(3, {4}).list(4, {3}).ring({0, 1, 2});
    while (rig.all<SeedEvidence>().empty()) {
        REQUIRE_FALSE(rig.state().finished());
        rig.pivot();
    }
    CHECK(rig.state().counters.freedRings == 1);
    CHECK(rig.state().retryLevel == 0);
}

TEST_CASE("7 the alert of a hole names the first of its points that is on no boundary") {
    Rig rig(ringAndSeed());
    rig.type(0, kPositiveX).ring({0, 1, 2});
    while (rig.state().alerts.empty()) rig.pivot();
    CHECK(rig.state().alerts[0].point == 1);
}
