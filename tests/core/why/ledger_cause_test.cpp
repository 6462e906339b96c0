/// Planted causes: small inputs whose run can be followed by hand, and the exact address that the
/// ledger and the moments of a failure must name.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <set>

#include "spiraling_edge/run/decision_query.h"
#include "spiraling_edge/scenes/scenes.h"
#include "spiraling_edge/why/failure_moments.h"
#include "spiraling_edge/why/ledger.h"
#include "support/clouds.h"
#include "support/oracles.h"
#include "support/random_points.h"
#include "support/rig.h"
#include "support/subjects.h"

using namespace se;
using namespace se::test;

namespace {

/// A point with six around it, each of which lists the others: pivot 1 makes all triangles, and
/// pivots 2 to 7 are those around, whose neighbors are all in triangles already. `more` are points
/// at `place` that only point 0 lists.
PointSet hexagon(const std::vector<Vec3>& more = {}) {
    std::vector<Vec3> position{Vec3(0)};
    for (int i = 0; i < 6; ++i) position.push_back(polar(60.0 * i));
    std::vector<Points> lists(7);
    for (Index p = 0; p < 7; ++p) {
        for (Index q = 0; q < 7; ++q) {
            if (q != p) lists[p].push_back(q);
        }
        std::stable_sort(lists[p].begin(), lists[p].end(), [&](Index a, Index b) {
            return glm::length(position[a] - position[p]) + 1e-6 <
                   glm::length(position[b] - position[p]);
        });
    }
    for (const Vec3& x : more) {
        lists[0].push_back(static_cast<Index>(position.size()));
        lists.push_back({});
        position.push_back(x);
    }
    return pointsAt(std::move(position), lists);
}

/// The number of the pivot at a point that is pivot once.
std::uint32_t pivotAt(const PointSet& points, Index p) {
    const std::vector<Event> events = eventsOf(points, paper());
    std::uint32_t number = 0;
    for (const Event& event : events) {
        const auto* pivot = std::get_if<PivotEvidence>(&event.evidence);
        if (pivot == nullptr || pivot->pivot != p) continue;
        REQUIRE(number == 0);
        number = event.address.pivot;
    }
    return number;
}

/// The test of `q` in the angle sort of pivot `p`: one for each listed point, in their order.
std::string sortAt(const PointSet& points, Index p, Index q) {
    const auto list = points.neighbors[p];
    const auto place = std::find(list.begin(), list.end(), q) - list.begin();
    return std::to_string(pivotAt(points, p)) + ".sort." + std::to_string(place + 1);
}

Ledger ledgerOf(const PointSet& points, const Subject& subject, const Params& params = paper()) {
    const auto ledger = why(points, params, subject);
    REQUIRE(ledger.ok());
    return ledger.value();
}
std::string causeOf(const PointSet& points, const Subject& subject,
                    const Params& params = paper()) {
    const Ledger ledger = ledgerOf(points, subject, params);
    REQUIRE(ledger.cause < ledger.lines.size());
    return toString(ledger.lines[ledger.cause].event.address);
}

/// Of two points, the one that is pivot later.
Index laterOf(const PointSet& points, Index a, Index b) {
    return pivotAt(points, a) > pivotAt(points, b) ? a : b;
}

/// The only failure of a class, with its moments.
RunFailure failureAt(const PointSet& points, std::string_view kind, const Points& at) {
    const std::vector<RunFailure> all = failuresOf(points, paper());
    const auto found = std::find_if(all.begin(), all.end(), [&](const RunFailure& each) {
        return each.failure.kind->name == kind && each.failure.points == at;
    });
    REQUIRE(found != all.end());
    return *found;
}

}  // namespace

TEST_CASE("ledger: a diagonal of a finished hexagon fell to the angle sort of its later pivot") {
    // Start or end looks at the point beyond it after the sort; that refuses nothing.
    const PointSet points = hexagon();
    for (const auto& [a, b] : {std::pair<Index, Index>{1, 3}, {2, 4}, {3, 5}, {6, 2}, {1, 4}}) {
        CAPTURE(a);
        CAPTURE(b);
        const Index later = laterOf(points, a, b);
        const Ledger ledger = ledgerOf(points, Subject::edge(a, b));
        const Address cause = ledger.lines[ledger.cause].event.address;
        CHECK(toString(cause) == sortAt(points, later, later == a ? b : a));
        CHECK(std::any_of(ledger.lines.begin(), ledger.lines.end(), [&](const LedgerLine& line) {
                  return line.event.address.stage == Stage::Limits &&
                         line.event.address.pivot == cause.pivot;
              }) == (std::max(a, b) - std::min(a, b) != 3));
    }
}

TEST_CASE("ledger: a missing triangle fell with the last of its missing edges") {
    const PointSet points = hexagon();
    Points corners{1, 3, 5};
    std::sort(corners.begin(), corners.end(),
              [&](Index a, Index b) { return pivotAt(points, a) < pivotAt(points, b); });
    // Both edges at the last pivot fell there, one test after the other.
    const Index last = corners[2];
    const std::string first = sortAt(points, last, corners[0]);
    const std::string second = sortAt(points, last, corners[1]);
    const bool inOrder = addressFromString(first)->n < addressFromString(second)->n;
    const Index other = inOrder ? corners[1] : corners[0];
    Points order{1, 3, 5};
    do {
        const Subject subject = Subject::triangle(order[0], order[1], order[2]);
        const Ledger ledger = ledgerOf(points, subject);
        CAPTURE(ledger.answer);
        CHECK(toString(ledger.lines[ledger.cause].event.address) == (inOrder ? second : first));
        const bool named =
            ledger.answer.find(nameOf(Subject::edge(last, other))) != std::string::npos ||
            ledger.answer.find(nameOf(Subject::edge(other, last))) != std::string::npos;
        CHECK(named);
    } while (std::next_permutation(order.begin(), order.end()));
}

TEST_CASE("ledger: a point in the direction of a nearer one fell there, not when all was DONE") {
    // 7 lies behind 2 seen from 0; the outer points see 0 again when it is DONE.
    PointSet points = hexagon({polar(60, 1.8)});
    NeighborLists lists;
    for (Index p = 0; p < points.size(); ++p) {
        Points list(points.neighbors[p].begin(), points.neighbors[p].end());
        if (p != 0 && p != 7) list.push_back(7);
        if (p == 7) list = {2, 1, 3, 0, 4, 6, 5};
        lists.append(list);
    }
    points.neighbors = lists;
    // Seven listed points are sorted; the tie of equal angles is the eighth event.
    CHECK(causeOf(points, Subject::edge(0, 7)) == "1.sort.8");
    CHECK(causeOf(points, Subject::edge(7, 0)) == "1.sort.8");
    // Its other edges are in the mesh.
    CHECK(ledgerOf(points, Subject::edge(0, 2)).present);
    CHECK(ledgerOf(points, Subject::edge(2, 7)).present);
    CHECK(causeOf(points, Subject::triangle(0, 2, 7)) == "1.sort.8");
    CHECK(causeOf(points, Subject::triangle(7, 0, 2)) == "1.sort.8");
}

TEST_CASE("ledger: a point that no later fan could hold fell at its own test") {
    // Only 0 lists 7; the fans of pivots 2 to 7 are refused too, without it.
    const PointSet points = hexagon({polar(60, 1.8)});
    CHECK(causeOf(points, Subject::point(7)) == "1.sort.8");
    CHECK(causeOf(points, Subject::edge(0, 7)) == "1.sort.8");
    const RunFailure failure = failureAt(points, "lost_points", {7});
    CHECK(toString(failure.moments.touched.event.address) == "1.sort.7");
    CHECK(toString(failure.moments.decided.event.address) == "1.sort.8");
    CHECK(failure.moments.created.event.address.stage == Stage::Strand);
}

TEST_CASE("ledger: a point has the refused fans in which it would have been first or last") {
    // Pivots 2 to 7 around the hexagon have over 180 degrees between their two ring neighbors.
    const PointSet points = hexagon();
    for (Index p = 1; p <= 6; ++p) {
        CAPTURE(p);
        Points pivots;
        for (const LedgerLine& line : ledgerOf(points, Subject::point(p)).lines) {
            if (line.event.address.stage != Stage::TwoPoint) continue;
            CHECK(line.role == LineRole::Refused);
            pivots.push_back(line.pivot);
        }
        std::sort(pivots.begin(), pivots.end());
        Points beside{p == 1 ? Index{6} : p - 1, p == 6 ? Index{1} : p + 1};
        std::sort(beside.begin(), beside.end());
        CHECK(pivots == beside);
    }
}

TEST_CASE(
    "ledger: a point that one of its entries takes has the refused fan, whatever the others") {
    // Without the circumsphere's test, which would take it once more.
    Params params = paperBut(&RobustRules::gap);
    params.paper.sphere = false;
    std::size_t seen = 0;
    for (const std::uint64_t seed : {26, 41}) {
        CAPTURE(seed);
        const PointSet points = randomPoints(seed);
        const std::vector<Event> events = eventsOf(points, params);
        std::set<Index> taken;         // by some entry, at this pivot
        std::set<Index> refusedAgain;  // of these, by a later entry
        for (const Event& event : events) {
            if (isA<PivotEvidence>(event)) {
                taken.clear();
                refusedAgain.clear();
            }
            if (const auto* e = as<ReciprocalEvidence>(event)) {
                if (e->verdict == Verdict::Kept) taken.insert(e->point);
                if (e->verdict != Verdict::Kept && taken.contains(e->point))
                    refusedAgain.insert(e->point);
            }
            const auto* hole = as<HoleEvidence>(event);
            if (hole != nullptr && hole->verdict == Verdict::FarSide)
                refusedAgain.erase(hole->point);
            if (!isA<GuardEvidence>(event)) continue;
            for (const Index p : refusedAgain) {
                ++seen;
                CAPTURE(toString(event.address));
                const Ledger ledger = ledgerOf(points, Subject::point(p), params);
                CHECK(std::any_of(ledger.lines.begin(), ledger.lines.end(), [&](const auto& line) {
                    return line.event.address == event.address && line.role == LineRole::Refused;
                }));
            }
        }
    }
    CHECK(seen > 0);
}

TEST_CASE("ledger: an edge has only tests at its own two pivots") {
    const PointSet points = hexagon();
    for (Index a = 0; a < 7; ++a) {
        for (Index b = a + 1; b < 7; ++b) {
            for (const LedgerLine& line : ledgerOf(points, Subject::edge(a, b)).lines) {
                CAPTURE(toString(line.event.address));
                // A triangle at one of its points is no fact about the edge.
                const auto* emit = std::get_if<EmitEvidence>(&line.event.evidence);
                CHECK((emit == nullptr || line.role == LineRole::Made));
                if (line.role != LineRole::Taken && line.role != LineRole::Refused) continue;
                CHECK((line.pivot == a || line.pivot == b));
            }
        }
    }
}

TEST_CASE("ledger: two points that find only each other fell with the last fan of two") {
    const PointSet points = pointsAt({{0, 0, 0}, {1, 0, 0}}, {{1}, {0}});
    // After the seed 0, 1 made nothing, the seed 1, 0 is tried.
    CHECK(causeOf(points, Subject::edge(0, 1)) == "4.twopoint.1");
    // A point's own fans do not count: it is the pivot there.
    CHECK(causeOf(points, Subject::point(0)) == "3.twopoint.1");
    CHECK(causeOf(points, Subject::point(1)) == "4.twopoint.1");
}

TEST_CASE("ledger: a triangle that is there names its own emit, an edge the first triangle at it") {
    const PointSet points = hexagon();
    EventLog log;
    const Run run = runAll(points, paper(), &log);
    REQUIRE(run.state.triangles.size() == 6);
    for (Index i = 0; i < 6; ++i) {
        const Triangle& t = run.state.triangles[i];
        const std::string made = "1.emit." + std::to_string(i + 1);
        CHECK(causeOf(points, Subject::triangle(t.a, t.b, t.c)) == made);
        CHECK(causeOf(points, Subject::edge(t.b, t.c)) == made);
    }
    CHECK(causeOf(points, Subject::point(0)) == "1.emit.1");
}

TEST_CASE("ledger: a triangle whose edges all have others fell with the last of these") {
    // Three triangles about 0 leave the one outside of them.
    const PointSet points = pointsAt({Vec3(0), polar(0), polar(120), polar(240)},
                                     {{1, 2, 3}, {0, 2, 3}, {0, 1, 3}, {0, 1, 2}});
    REQUIRE(runAll(points, paper()).state.triangles.size() == 3);
    CHECK(causeOf(points, Subject::triangle(1, 2, 3)) == "1.emit.3");
}

TEST_CASE("ledger: of an edge that no pivot tested, who lists whom, and whether it was a pivot") {
    // 0 and 1 are on a wall and find no third point there: they are passed over.
    PointSet points =
        pointsAt({{0, 0, 0}, {1, 0, 0}, {0.5, 1, 0}, {0.5, 2, 0}}, {{1}, {0, 2}, {1, 0}, {}});
    points.type[0] = points.type[1] = kNegativeY;
    // Else 1 is UNUSED again, and 2 begins a ring with it.
    const Params params = paperBut(&Readings::keepSeeds);
    const auto says = [&](const Subject& subject, std::string_view words) {
        const Ledger ledger = ledgerOf(points, subject, params);
        CAPTURE(ledger.answer);
        CHECK_FALSE(ledger.present);
        CHECK(ledger.answer.find(words) != std::string::npos);
    };
    says(Subject::edge(1, 2), "1 lists 2, but looked at no neighbor when it was the pivot.");
    says(Subject::edge(1, 2), "2 lists 1, but was never a pivot.");
    says(Subject::edge(0, 2), "2 lists 0, but was never a pivot.");
    says(Subject::edge(0, 3), "Neither of 0 and 3 lists the other");
    says(Subject::point(2), "Point 2 is listed by 1 point, but none of them was a pivot");
    says(Subject::point(3), "No point lists 3 ");
}

TEST_CASE(
    "ledger: an edge that a flip took out names the last flip, one that came back its return") {
    const Params params = robust();
    std::size_t gone = 0;
    std::size_t back = 0;
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
        PointFile file = closedFamilies(0.5)[0].sample(seed);
        Random random(seed);
        for (Vec3& x : file.position) x += 0.08 * random.inCube();
        const PointSet points = prepared(file);
        const std::vector<Event> events = eventsOf(points, params);
        std::size_t asked = 0;
        for (const Event& event : events) {
            const auto* flip = std::get_if<FlipEvidence>(&event.evidence);
            if (flip == nullptr || ++asked > 40) continue;
            const Ledger ledger = ledgerOf(points, Subject::edge(flip->u, flip->v), params);
            CAPTURE(ledger.answer);
            std::size_t undone = 0;
            for (std::size_t i = 0; i < ledger.lines.size(); ++i) {
                if (ledger.lines[i].role == LineRole::Undone) undone = i;
            }
            REQUIRE(ledger.lines[undone].role == LineRole::Undone);
            if (ledger.present) {
                CHECK(ledger.cause > undone);
                ++back;
            } else {
                CHECK(ledger.cause == undone);
                ++gone;
            }
        }
    }
    MESSAGE(gone, " gone, ", back, " back");
    CHECK(gone > 0);
}

TEST_CASE("ledger: a point that was taken out with its patch and put back names its return") {
    // A hexagon of 24 triangles, and a pillow of 2 over it, whose points list both.
    std::vector<Vec3> position;
    for (int j = -2; j <= 2; ++j) {
        for (int i = -2; i <= 2; ++i) {
            if (std::abs(i + j) <= 2) position.emplace_back(i + 0.5 * j, std::sqrt(0.75) * j, 0.0);
        }
    }
    const auto first = static_cast<Index>(position.size());
    for (const double degrees : {30.0, 150.0, 270.0})
        position.push_back(polar(degrees, std::sqrt(1.0 / 3.0)) + Vec3(0, 0, 0.05));
    std::vector<Points> lists(position.size());
    for (Index p = 0; p < position.size(); ++p) {
        for (Index q = 0; q < position.size(); ++q) {
            const bool listed = glm::length(position[q] - position[p]) < 1.1 && q != p;
            if (listed && (p >= first || q < first)) lists[p].push_back(q);
        }
        std::stable_sort(lists[p].begin(), lists[p].end(), [&](Index a, Index b) {
            return glm::length(position[a] - position[p]) < glm::length(position[b] - position[p]);
        });
    }
    const PointSet points = pointsAt(std::move(position), lists);
    Params params = paperBut(&RobustRules::dropPatches);
    params.robust.reinsert = true;
    const State state = runAll(points, params).state;
    REQUIRE(state.repair.droppedPatches == 1);
    // The first two take the room of the third.
    REQUIRE(state.repair.reinserted == 2);
    for (Index p = first; p < points.size(); ++p) {
        CAPTURE(p);
        if (state.repair.sideOf[p] == kNone) continue;
        const Ledger ledger = ledgerOf(points, Subject::point(p), params);
        CHECK(ledger.present);
        std::vector<Stage> changes;
        for (const LedgerLine& line : ledger.lines) {
            if (line.role == LineRole::Undone || line.event.address.stage == Stage::Reinsert)
                changes.push_back(line.event.address.stage);
        }
        CHECK((changes == std::vector<Stage>{Stage::DropPatch, Stage::Reinsert}));
        const LedgerLine& cause = ledger.lines[ledger.cause];
        CHECK(cause.event.address.stage == Stage::Reinsert);
        CHECK(testedPoint(cause.event) == p);
        CHECK(cause.role == LineRole::Made);
    }
}

TEST_CASE("ledger: a third point of a wall fell with the fan that it was inserted for") {
    // Figure 14 with 205 degrees at 0: the third point is taken back, and nothing is made.
    PointSet points = pointsAt({{0, 0, 0}, {0.8, -0.2, 0}, {-1, -0.2, 0}}, {{1, 2}, {}, {}});
    for (Index p = 0; p < 3; ++p) points.type[p] = kNegativeY;
    REQUIRE(runAll(points, paper()).state.triangles.empty());
    CHECK(causeOf(points, Subject::edge(0, 1)) == "1.twopoint.1");
    CHECK(causeOf(points, Subject::edge(0, 2)) == "1.twopoint.1");
    CHECK(causeOf(points, Subject::point(2)) == "1.twopoint.1");
    // Start and end looked at each other's point: that refuses nothing.
    const RunFailure failure = failureAt(points, "isolated_points", {2});
    CHECK_FALSE(std::holds_alternative<LimitEvidence>(failure.moments.decided.event.evidence));
}

TEST_CASE("moments: a point that start or end moved past fell with the first move that passed it") {
    std::size_t seen = 0;
    for (std::uint64_t seed = 1; seed <= 12; ++seed) {
        CAPTURE(seed);
        PointFile file = closedFamilies(0.4)[seed % 2].sample(seed);
        Random random(seed);
        for (Vec3& x : file.position) x += 0.12 * random.inCube();
        const PointSet points = prepared(file, reach(16));
        const std::vector<Event> events = eventsOf(points, paper());
        const std::vector<RunFailure> all = failuresOf(points, paper());
        for (const RunFailure& each : all) {
            if (each.failure.kind->name != "lost_points") continue;
            const Event& cause = each.moments.decided.event;
            const auto* dropped = std::get_if<DropEvidence>(&cause.evidence);
            CHECK_FALSE((dropped != nullptr && dropped->verdict == Verdict::Outside));
            const auto* move = std::get_if<LimitEvidence>(&cause.evidence);
            if (move == nullptr) continue;
            ++seen;
            CAPTURE(toString(cause.address));
            CHECK(move->verdict == Verdict::Moved);
            const DropEvidence* drop = nullptr;
            for (const Event& event : events) {
                if (event.address.pivot != cause.address.pivot) continue;
                const auto* e = std::get_if<DropEvidence>(&event.evidence);
                if (e != nullptr && e->point == each.failure.points[0]) drop = e;
            }
            REQUIRE(drop != nullptr);
            CHECK(drop->side == move->side);
            const auto passes = [&](const LimitEvidence& e) {
                return e.side == drop->side && e.verdict == Verdict::Moved &&
                       (e.side == Side::Start ? e.toDegrees >= drop->degrees
                                              : e.toDegrees <= drop->degrees);
            };
            CHECK(passes(*move));
            for (const Event& event : events) {
                if (event.address.pivot != cause.address.pivot) continue;
                const auto* e = std::get_if<LimitEvidence>(&event.evidence);
                if (e != nullptr && event.address.n < cause.address.n) CHECK_FALSE(passes(*e));
            }
        }
    }
    MESSAGE(seen, " points passed");
    CHECK(seen > 0);
}
