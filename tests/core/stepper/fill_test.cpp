/// RobustRules::fill: a ring that would be freed is closed by ears, unless the surface ends there.
#include <doctest/doctest.h>

#include <algorithm>

#include "spiraling_edge/geometry/triangle_shape.h"
#include "support/clouds.h"
#include "support/oracles.h"
#include "support/rig.h"

using namespace se;
using namespace se::test;

namespace {

Params fillWith(std::initializer_list<bool RobustRules::*> rules = {}) {
    Params params = paperBut(&RobustRules::fill);
    for (const auto rule : rules) params.robust.*rule = true;
    return params;
}

/// A hole: points at these angles of the unit circle; the ring is clockwise around it.
std::vector<Vec3> hole(const std::vector<double>& degrees) {
    std::vector<Vec3> position;
    for (const double d : degrees) position.push_back(polar(-d));
    return position;
}
std::vector<double> regular(std::size_t count) {
    std::vector<double> degrees;
    for (std::size_t i = 0; i < count; ++i) {
        degrees.push_back(360.0 * static_cast<double>(i) / static_cast<double>(count));
    }
    return degrees;
}
Points upTo(std::size_t count) {
    Points all;
    for (Index p = 0; p < count; ++p) all.push_back(p);
    return all;
}

/// True if the new triangles use no directed edge twice and close the hole.
bool closesHole(const Triangles& triangles, std::size_t count) {
    EdgeTable table(count);
    for (const Triangle& t : triangles) {
        if (table.has(t.a, t.b) || table.has(t.b, t.c) || table.has(t.c, t.a)) return false;
        table.add(t);
    }
    bool whole = triangles.size() == count - 2;
    // The ring steps p -> p + 1 are edges of the mesh about the hole; the hole's are the others.
    for (Index p = 0; p < count; ++p) {
        whole = whole && table.has(static_cast<Index>((p + 1) % count), p);
    }
    return whole;
}

}  // namespace

TEST_CASE("fill: a ring that would be freed is closed, one ear at each step") {
    for (const std::size_t count : {3U, 4U, 5U, 9U, 20U}) {
        Rig rig(hole(regular(count)), fillWith());
        rig.ring(upTo(count)).startAt(Phase::Fill).pivot();
        CHECK(rig.triangles().size() == 1);
        rig.run();
        CHECK_MESSAGE(closesHole(rig.triangles(), count), count);
        CHECK(rig.state().counters.holes == 0);
        CHECK(rig.state().alerts.empty());
        CHECK(rig.state().finished());
    }
}

namespace {

/// A square of four points that lie where the surface ends, each with six finished points close
/// behind it: RobustRules::rim makes no triangle of them, since it would be too large.
Rig& rimSquare(Rig& rig) {
    Index next = 4;
    for (Index p = 0; p < 4; ++p) {
        Points list;
        for (int i = 0; i < 6; ++i) list.push_back(next++);
        rig.done(list).list(p, list);
    }
    return rig.ring({0, 1, 2, 3});
}
std::vector<Vec3> rimSquarePoints() {
    std::vector<Vec3> position = hole(regular(4));
    for (int p = 0; p < 4; ++p) {
        for (int i = 0; i < 6; ++i) {
            position.push_back(position[static_cast<std::size_t>(p)] +
                               polar(-90.0 * p - 10 + 4 * i, 0.1 + 0.01 * i));
        }
    }
    return position;
}

}  // namespace

TEST_CASE("fill: without the rule the ring is freed and reported, with it the hole is closed") {
    Params rimOnly = paperBut(&RobustRules::rim);
    Rig freed(rimSquarePoints(), rimOnly);
    rimSquare(freed).run();
    CHECK(freed.triangles().empty());
    CHECK(freed.state().counters.freedRings == 1);
    CHECK(freed.state().counters.filled == 0);
    Rig filled(rimSquarePoints(), fillWith({&RobustRules::rim}));
    rimSquare(filled).run();
    CHECK(filled.triangles().size() == 2);
    CHECK(filled.state().counters.filled == 2);
    CHECK(filled.state().counters.freedRings == 0);
}

TEST_CASE("fill: a ring longer than maxFillLength is freed") {
    for (const std::uint32_t longest : {3U, 4U}) {
        Params params = fillWith({&RobustRules::rim});
        params.maxFillLength = longest;
        Rig rig(rimSquarePoints(), params);
        rimSquare(rig).run();
        CHECK(rig.triangles().empty() == (longest == 3));
        CHECK(rig.state().finished());
    }
    CHECK(Params{}.maxFillLength == 64);
}

TEST_CASE("fill: a ring wider than maxFillWidth spacings of its points is freed") {
    // The square is sqrt(2) wide, and each corner's nearest neighbor 0.1 away.
    for (const double widest : {14.1, 14.2}) {
        Params params = fillWith({&RobustRules::rim});
        params.maxFillWidth = widest;
        Rig rig(rimSquarePoints(), params);
        rimSquare(rig).run();
        CHECK(rig.triangles().empty() == (widest < 14.142));
        CHECK(rig.state().finished());
    }
}

TEST_CASE("fill: the ear with the best least angle goes first") {
    for (std::uint64_t seed = 1; seed <= 30; ++seed) {
        Random random(seed);
        std::vector<double> degrees;
        const std::size_t count = 4 + random.below(6);
        while (degrees.size() < count) degrees.push_back(random.between(0, 360));
        std::sort(degrees.begin(), degrees.end());
        // Some rings of random points are no ears anywhere: a turn over 180 degrees at one.
        double widest = degrees[0] + 360 - degrees.back();
        for (std::size_t i = 1; i < count; ++i) {
            widest = std::max(widest, degrees[i] - degrees[i - 1]);
        }
        if (widest > 170) continue;
        Rig rig(hole(degrees), fillWith());
        rig.ring(upTo(count)).startAt(Phase::Fill).pivot();
        const auto made = rig.all<FillEvidence>();
        REQUIRE(made.size() == 1);
        double best = 0;
        for (Index p = 0; p < count; ++p) {
            const auto before = static_cast<Index>((p + count - 1) % count);
            const auto after = static_cast<Index>((p + 1) % count);
            const double cosine = leastAngleCosine(rig.points(), {p, before, after});
            best = std::max(best, std::acos(cosine) * 180 / kPi);
        }
        CHECK(made[0].leastDegrees == doctest::Approx(best));
        CHECK(made[0].ringLength == count);
        CHECK_FALSE(made[0].forced);
        CHECK(rig.triangles() == Triangles{{made[0].pivot, made[0].first, made[0].last}});
    }
}

TEST_CASE("fill: an ear with a fault is made only where nothing else closes a hole of four") {
    const auto closed = [](std::size_t count, std::initializer_list<bool RobustRules::*> rules) {
        Rig rig(hole(regular(count)), fillWith(rules));
        // Every other normal leans so far that each ear is against one of its corners.
        for (Index p = 0; p < count; ++p) {
            if (p % 2 == 0) rig.normal(p, Vec3(0, 0, -0.2) + polar(10.0 * p));
        }
        rig.ring(upTo(count)).startAt(Phase::Fill).run();
        for (const auto& made : rig.all<FillEvidence>()) CHECK(made.forced);
        CHECK(rig.state().finished());
        return rig.all<FillEvidence>().size();
    };
    CHECK(closed(4, {&RobustRules::noFold}) == 2);
    // In a longer ring one fault leads to more: it stays open.
    CHECK(closed(5, {&RobustRules::noFold}) == 0);
    CHECK(closed(12, {&RobustRules::noFold}) == 0);
    // No neighbors on any side: the surface ends there.
    CHECK(closed(12, {&RobustRules::noFold, &RobustRules::rim}) == 0);
}

TEST_CASE("fill: of ears with faults the one with the fewest goes first, then the best angle") {
    // 1 0 2 is equilateral, the others have an angle of 30 degrees.
    const std::vector<Vec3> position = hole({0, 120, 240, 300});
    {
        // Against 0 and 2, an ear at 1 or 3 is flipped, and one at 0 or 2 against one corner.
        Rig rig(position, fillWith({&RobustRules::noFold}));
        rig.normal(0, Vec3(0, 0, -1)).normal(2, Vec3(0, 0, -1));
        rig.ring(upTo(4)).startAt(Phase::Fill).pivot();
        const auto made = rig.all<FillEvidence>();
        REQUIRE(made.size() == 1);
        CHECK(made[0].forced);
        CHECK((made[0].pivot == 0 || made[0].pivot == 2));
    }
    for (const bool cut : {false, true}) {
        // Each ear is against a corner; a finished triangle cuts those at 0 and 1.
        std::vector<Vec3> more = position;
        more.insert(more.end(), {{0.3, 0, -1}, {0.3, 0, 1}, {0.35, -0.05, 1}});
        Rig rig(more, fillWith({&RobustRules::noFold}));
        for (Index p = 0; p < 4; p += 2) rig.normal(p, Vec3(0, 0, -0.2) + polar(10.0 * p));
        if (cut) rig.mesh({{4, 5, 6}});
        for (Index p = 0; p < 4; ++p) rig.list(p, {4, 5, 6});
        rig.ring(upTo(4)).startAt(Phase::Fill).pivot();
        const auto made = rig.all<FillEvidence>();
        REQUIRE(made.size() == 1);
        CHECK(made[0].forced);
        CHECK((made[0].pivot >= 2) == cut);
    }
}

TEST_CASE("fill: an ear that the guard refuses is not made even to close a ring of four") {
    // 0 2 and 1 3 are edges already.
    Rig rig(hole(regular(4)), fillWith({&RobustRules::guard}));
    rig.mesh({{0, 2, 1}, {3, 1, 2}}).ring(upTo(4)).startAt(Phase::Fill).run();
    CHECK(rig.newTriangles().empty());
    CHECK(rig.state().counters.freedRings == 1);
    CHECK(rig.state().counters.holes == 1);
    REQUIRE(rig.state().alerts.size() == 1);
    CHECK(rig.state().alerts[0].kind == AlertKind::Hole);
    Rig unguarded(hole(regular(4)), fillWith());
    unguarded.mesh({{0, 2, 1}, {3, 1, 2}}).ring(upTo(4)).startAt(Phase::Fill).run();
    CHECK(unguarded.newTriangles().size() == 2);
}

TEST_CASE("fill: no ear beside an open step") {
    Rig rig(hole(regular(4)), fillWith());
    rig.ring(upTo(4)).open(0).startAt(Phase::Fill).pivot();
    const auto made = rig.all<FillEvidence>();
    REQUIRE(made.size() == 1);
    CHECK((made[0].pivot == 2 || made[0].pivot == 3));
    Rig all(hole(regular(4)), fillWith());
    all.ring(upTo(4)).open(0).open(2).startAt(Phase::Fill).pivot();
    CHECK(all.all<FillEvidence>().empty());
}

// ---- openings -----------------------------------------------------------------------------------

namespace {

/// A regular ring of which the first `rim` points lie where the surface ends, the others have a
/// finished point on every side.
std::vector<Vec3> withRim(std::size_t count) {
    std::vector<Vec3> position = hole(regular(count));
    for (std::size_t p = 0; p < count; ++p) {
        for (int i = 0; i < 4; ++i) position.push_back(position[p] + polar(90.0 * i, 5));
    }
    return position;
}
Rig& setRim(Rig& rig, std::size_t count, std::size_t rim) {
    for (Index p = 0; p < count; ++p) {
        Points list;
        for (Index i = 0; i < 4; ++i) list.push_back(static_cast<Index>(count) + 4 * p + i);
        rig.done(list);
        if (p < rim) list.resize(2);
        rig.list(p, list);
    }
    return rig.ring(upTo(count));
}

}  // namespace

TEST_CASE("rim: a ring of which more than two in three points are where the surface ends stays") {
    for (const std::size_t rim : {6U, 7U, 9U}) {
        for (const bool on : {false, true}) {
            // As if all circuits were over but for this pivot.
            Rig late(withRim(9), on ? fillWith({&RobustRules::rim}) : fillWith());
            setRim(late, 9, rim).startAt(Phase::Advance).retryLevel(kDelayedAllowed, 8);
            late.run();
            const bool opening = on && rim > 6;
            CHECK(late.triangles().empty() == opening);
            CHECK(late.state().counters.openings == (opening ? 1 : 0));
            CHECK(late.state().counters.holes == 0);
            CHECK(late.state().alerts.empty());
        }
    }
}

TEST_CASE(
    "rim: a ring of which more than two in three are rim points stays, without the rule too") {
    for (const Index rim : {6U, 7U}) {
        Rig late(withRim(9), fillWith());
        setRim(late, 9, 0).startAt(Phase::Advance).retryLevel(kDelayedAllowed, 8);
        for (Index p = 0; p < rim; ++p) late.rim(p, {});
        late.run();
        CHECK(late.state().counters.openings == (rim > 6 ? 1 : 0));
    }
}

TEST_CASE("rim: a ring that runs round a patch of the surface is an opening") {
    for (const bool patch : {false, true}) {
        std::vector<Vec3> position = withRim(7);
        if (patch) {
            for (Vec3& x : position) x.y = -x.y;
        }
        Rig rig(position, fillWith({&RobustRules::rim}));
        setRim(rig, 7, 0).startAt(Phase::Advance).retryLevel(kDelayedAllowed, 6);
        rig.run();
        CHECK(rig.triangles().empty() == patch);
        CHECK(rig.state().counters.openings == (patch ? 1 : 0));
    }
}

TEST_CASE("rim: a ring as narrow as a seam is no opening, wherever its points lie") {
    for (const double width : {0.5, 3.0}) {
        // Two rows of twelve, one apart in their row, with no neighbors between.
        std::vector<Vec3> position;
        for (int i = 0; i < 12; ++i) position.emplace_back(i, width, 0);
        for (int i = 11; i >= 0; --i) position.emplace_back(i, 0, 0);
        const std::size_t count = position.size();
        for (std::size_t p = 0; p < count; ++p) {
            const double out = p < count / 2 ? 1.0 : -1.0;
            position.push_back(position[p] + Vec3(0, out, 0));
            position.push_back(position[p] + Vec3(0.1, out, 0));
            position.push_back(position[p] + Vec3(-0.1, out, 0));
        }
        Rig rig(position, fillWith({&RobustRules::rim}));
        for (Index p = 0; p < count; ++p) {
            const auto first = static_cast<Index>(count + 3 * p);
            rig.done({first, first + 1, first + 2}).list(p, {first, first + 1, first + 2});
        }
        rig.ring(upTo(count)).startAt(Phase::Advance).retryLevel(kDelayedAllowed, 23).run();
        const bool seam = width < 1.0;
        CHECK(rig.triangles().empty() == !seam);
        CHECK(rig.state().counters.openings == (seam ? 0 : 1));
    }
}

TEST_CASE("fill: a ring that touches a wall gets no ear with a fault") {
    for (const bool wall : {false, true}) {
        Rig rig(hole(regular(4)), fillWith({&RobustRules::noFold}));
        for (Index p = 0; p < 4; p += 2) rig.normal(p, Vec3(0, 0, -0.2) + polar(10.0 * p));
        if (wall) rig.type(1, kPositiveX);
        rig.ring(upTo(4)).startAt(Phase::Fill).run();
        CHECK(rig.triangles().empty() == wall);
    }
}

TEST_CASE("rim: a ring of four is a hole even if all of it is where the surface ends") {
    Rig rig(withRim(4), fillWith({&RobustRules::rim}));
    setRim(rig, 4, 4).startAt(Phase::Advance).retryLevel(kDelayedAllowed, 3);
    rig.run();
    CHECK(rig.triangles().size() == 2);
    CHECK(rig.state().counters.openings == 0);
}

TEST_CASE("rim: a ring of up to five is a hole even if all of it lies on walls") {
    for (const std::size_t count : {4U, 5U, 6U}) {
        Rig rig(hole(regular(count)), fillWith({&RobustRules::rim}));
        for (Index p = 0; p < count; ++p) rig.type(p, kPositiveX);
        rig.ring(upTo(count)).startAt(Phase::Advance);
        rig.retryLevel(kDelayedAllowed, static_cast<Index>(count - 1)).run();
        CHECK(rig.triangles().empty() == (count > 5));
    }
}

// ---- whole runs ---------------------------------------------------------------------------------

TEST_CASE("fill: on rough clouds, fewer holes are left than without") {
    std::size_t with = 0;
    std::size_t without = 0;
    std::size_t filled = 0;
    for (std::uint64_t seed = 1; seed <= 12; ++seed) {
        PointFile file = closedFamilies(0.6)[seed % 4].sample(seed);
        Random random(seed);
        for (Vec3& x : file.position) x += 0.12 * random.inCube();
        const PointSet points = prepared(file);
        Params params = *paramsByName("robust");
        params.robust.rim = params.robust.reinsert = params.robust.closeHoles = params.robust.flip =
            params.robust.remesh = false;
        const Run on = runAll(points, params);
        params.robust.fill = false;
        const Run off = runAll(points, params);
        with += on.mesh.boundaryEdges;
        without += off.mesh.boundaryEdges;
        filled += on.state.counters.filled;
        CHECK(off.state.counters.filled == 0);
    }
    MESSAGE("boundary edges left: ", with, " with, ", without, " without; ears ", filled);
    CHECK(filled > 0);
    CHECK(with < without);
}
