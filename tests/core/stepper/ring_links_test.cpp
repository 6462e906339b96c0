/// Splits of rings together with the finished edges that they leave, and the next pivot after them.
#include <doctest/doctest.h>

#include "support/oracles.h"
#include "support/rig.h"

using namespace se;
using namespace se::test;

namespace {

/// The rules of the paper without the limits and the convexity test, so that a neighbor next to
/// start or end on the ring enters the fan as a candidate.
Params withoutLimits() {
    Params params = paper();
    params.paper.limits = params.paper.convex = false;
    return params;
}

}  // namespace

TEST_CASE("6.5 where end and the inserted points went with finished edges, start is next") {
    // 3 enters between 1 and 2, and is also next to 2 on the ring: 2 and 3 are a ring of two. Then
    // the new entry of 3 lies between two entries of 1.
    Rig rig({{0, 0, 0}, polar(0), polar(120), polar(60), {9, 1, 0}, {9, -1, 0}}, withoutLimits());
    rig.list(0, {3}).ring({0, 2, 3, 1, 4, 5, 1}).pivot();
    CHECK(rig.triangles() == Triangles{{0, 1, 3}, {0, 3, 2}});
    CHECK(rig.state().counters.closedRings == 1);
    for (const Index point : {2U, 3U}) CHECK(rig.status(point) == kDone);
    CHECK(rig.status(1) == 1);
    CHECK(rig.activeRing() == Points{1, 4, 5});
    CHECK(rig.state().rings.stack().empty());
    CHECK_FALSE(rig.all<AdvanceEvidence>().back().popped);
}

TEST_CASE("6.5 where start goes with a finished edge, the entry before it becomes start") {
    // First = 1 lies between two entries of 2, one of which is last.
    Params params = paper();
    params.paper.next = NextRule::Start;
    Rig rig({{0, 0, 0}, {1, 1, 0}, {-1, 1, 0}, {-2, 5, 0}, {2, 5, 0}}, params);
    rig.ring({0, 2, 3, 4, 2, 1}).pivot();
    CHECK(rig.triangles() == Triangles{{0, 1, 2}});
    CHECK(rig.status(1) == kDone);
    CHECK(rig.activeRing() == Points{2, 3, 4});
}

TEST_CASE("6.5 of a stacked ring that splits, one part keeps its place and the other is on top") {
    // 5 splits off the part with end, which is stacked; 6 then splits that part.
    Params params = paper();
    params.paper.active = ActiveRule::Other;
    params.paper.reciprocal = params.paper.sphere = false;
    Rig rig(
        {{0, 0, 0}, polar(0), polar(170), {-9, 1, 0}, {-9, 2, 0}, polar(60), polar(120), {9, 1, 0}},
        params);
    rig.list(0, {5, 6}).ring({0, 2, 3, 6, 4, 5, 7, 1}).pivot();
    CHECK(rig.triangles() == Triangles{{0, 1, 5}, {0, 5, 6}, {0, 6, 2}});
    CHECK(rig.state().counters.splits == 2);
    REQUIRE(rig.state().rings.stack().size() == 2);
    CHECK(rig.stackedRing(0) == Points{6, 4, 5});
    CHECK(rig.stackedRing(1) == Points{6, 2, 3});
    CHECK(rig.state().rings.length(rig.state().rings.active()) == 3);  // 1, 5 and 7
}

TEST_CASE("6.5 a ring of two finished edges that a split has stacked is closed there") {
    // Of the two parts 2 and 3 are the shorter one, with end.
    Params params = withoutLimits();
    params.paper.active = ActiveRule::Longer;
    Rig rig({{0, 0, 0}, polar(0), polar(120), polar(60), {9, 1, 0}, {9, -1, 0}}, params);
    rig.list(0, {3}).ring({0, 2, 3, 4, 5, 1}).pivot();
    CHECK(rig.state().counters.splits == 1);
    CHECK(rig.state().counters.closedRings == 1);
    CHECK(rig.state().rings.stack().empty());
    CHECK(rig.status(2) == kDone);
    CHECK(rig.activeRing() == Points{3, 4, 5, 1});
}
