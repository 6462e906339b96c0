#include "spiraling_edge/run/pivot_replay.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <limits>
#include <memory>
#include <string>

#include "spiraling_edge/mesh/mesh_compare.h"
#include "spiraling_edge/run/timeline.h"
#include "support/clouds.h"
#include "support/random_points.h"
#include "support/rule_values.h"

using namespace se;

namespace {

/// A ring as a cycle that begins at its least point, so that cycles can be compared.
std::vector<Index> cycle(std::vector<Index> points) {
    if (!points.empty()) {
        std::rotate(points.begin(), std::min_element(points.begin(), points.end()), points.end());
    }
    return points;
}

std::size_t indexOf(const PivotRecord& record, Stage stage) {
    return record.find({record.pivot, stage, 0}).value_or(record.events.size());
}

/// The neighbor ring that the stepper has: start, the candidates, end.
std::vector<RingPoint> liveRing(const State& live) {
    const NeighborRing& n = live.pivot;
    std::vector<RingPoint> ring{{live.rings.point(n.start), n.startAngle.degrees()}};
    for (const Candidate& each : n.candidates) ring.push_back({each.point, each.angle.degrees()});
    ring.push_back({live.rings.point(n.end), n.endAngle.degrees()});
    return ring;
}

/// Steps a run phase by phase beside the replay of its events.
class BesideTheStepper {
  public:
    BesideTheStepper(const PointSet& points, const Params& params)
        : stepper_(points, params, &log_), timeline_(points, params) {}

    /// Compares the first `most` pivots. Returns the number of rings compared.
    int compare(std::uint32_t most) {
        const State& live = stepper_.state();
        while (!live.finished() && !isRepair(live.phase) && live.counters.pivots < most) {
            const Phase phase = live.phase;
            if (log_.events().empty()) record_ = timeline_.record(live.counters.pivots + 1);
            stepper_.advance();
            const std::size_t known = log_.events().size();
            const bool hasRing = (phase == Phase::Pivot && live.phase == Phase::Sort) ||
                                 (phase >= Phase::Sort && phase <= Phase::Emit) ||
                                 (phase == Phase::Fill && live.phase == Phase::Emit);
            if (hasRing) compareRing(PivotReplay(record_).after(known - 1), phase);
            if (phase != Phase::Advance) continue;
            compareTests();
            log_.clear();
        }
        return compared_;
    }

  private:
    void compareRing(const DecisionState& replayed, Phase phase) {
        const State& live = stepper_.state();
        const NeighborRing& n = live.pivot;
        CAPTURE(toString(log_.events().back().address));
        CHECK(replayed.neighborRing() == liveRing(live));
        CHECK(replayed.first == live.rings.point(n.first));
        CHECK(replayed.last == live.rings.point(n.last));
        CHECK(replayed.sectorDegrees == n.lastAngle.degrees());
        ++compared_;
        if (phase != Phase::Emit) return;
        std::vector<Index> fan;
        for (const RingPoint& each : replayed.fan()) fan.push_back(each.point);
        CHECK(fan == n.spokes);
    }
    /// Each point tested by §6.3 stands between the two that it is tested with.
    void compareTests() {
        for (std::size_t i = 0; i < record_->events.size(); ++i) {
            const auto* test = std::get_if<SphereEvidence>(&record_->events[i].evidence);
            if (test == nullptr) continue;
            CAPTURE(toString(record_->events[i].address));
            const std::vector<RingPoint> ring = PivotReplay(record_).before(i).neighborRing();
            const std::array<Index, 3> three{test->t, test->q, test->s};
            const auto found =
                std::search(ring.begin(), ring.end(), three.begin(), three.end(),
                            [](const RingPoint& a, Index b) { return a.point == b; });
            REQUIRE(found != ring.end());
            CHECK(found[2].degrees - found[0].degrees == test->gapDegrees);
        }
    }

    EventLog log_;
    Stepper stepper_;
    Timeline timeline_;
    std::shared_ptr<const PivotRecord> record_;
    int compared_ = 0;
};

/// Compares the rings of a scene by some rules.
int compareRings(const Scene& scene, const Params& params, std::uint32_t most) {
    CAPTURE(scene.id);
    return BesideTheStepper(test::sceneNamed(scene.id), test::withStartOf(scene, params))
        .compare(most);
}

}  // namespace

TEST_CASE("After each stage the replayed neighbor ring is that of the stepper") {
    int compared = 0;
    for (const std::string rules : {"paper", "printed", "corrected", "robust"}) {
        CAPTURE(rules);
        test::forEachScene([&](const Scene& scene) {
            compared += compareRings(scene, *paramsByName(rules), 1000);
        });
    }
    CHECK(compared > 100000);
}

TEST_CASE("The replayed neighbor ring is that of the stepper by every value of a rule" *
          doctest::test_suite("long")) {
    for (const std::string base : {"paper", "robust"}) {
        test::forEachPaperRule(
            *paramsByName(base), [&](const Params& params, const std::string& rule) {
                CAPTURE(base);
                CAPTURE(rule);
                for (const char* id : {"four-edge-hole", "wrong-lists", "figure-14", "figure-18",
                                       "tee-at-wall", "long-lists", "small-sheet"})
                    compareRings(*findScene(id), params, 200);
            });
    }
}

TEST_CASE("The last event of every pivot shows the state after it") {
    for (const char* scene : {"sphere", "torus", "sheet"}) {
        CAPTURE(scene);
        Timeline timeline(test::sceneNamed(scene), Params{});
        for (std::uint32_t pivot = 1; pivot <= 200; pivot += 7) {
            const auto record = timeline.record(pivot);
            const DecisionState state = PivotReplay(record).after(record->events.size() - 1);
            CHECK(state.complete);
            CHECK(state.status == record->after.status);
            CHECK(state.finishedTriangles + state.newTriangles.size() ==
                  record->after.triangleCount);
        }
    }
}

TEST_CASE("Ring events change the ring one by one into that after the pivot") {
    Timeline timeline(test::sceneNamed("sphere"), Params{});
    int compared = 0;
    for (std::uint32_t pivot = 1; pivot <= 150; ++pivot) {
        const auto record = timeline.record(pivot);
        const bool plain = indexOf(*record, Stage::Split) == record->events.size() &&
                           indexOf(*record, Stage::Join) == record->events.size() &&
                           indexOf(*record, Stage::Done) == record->events.size();
        const std::size_t advance = indexOf(*record, Stage::Advance);
        if (!plain || advance == 0 || record->events[advance - 1].address.stage != Stage::Ring)
            continue;
        const DecisionState before = PivotReplay(record).after(advance - 1);
        const DecisionState after = PivotReplay(record).after(advance);
        REQUIRE_FALSE(before.rings.empty());
        REQUIRE_FALSE(after.rings.empty());
        CAPTURE(pivot);
        CHECK(cycle(before.rings[0].points) == cycle(after.rings[0].points));
        ++compared;
    }
    CHECK(compared > 60);
}

TEST_CASE("Candidates are marked from their first test on, and stay crossed once rejected") {
    Timeline timeline(test::sceneNamed("sphere"), Params{});
    std::size_t ever = 0;
    for (std::uint32_t pivot = 1; pivot <= 60; ++pivot) {
        const auto record = timeline.record(pivot);
        std::size_t known = 0;
        std::size_t rejected = 0;
        for (std::size_t i = 0; i < record->events.size(); ++i) {
            const DecisionState state = PivotReplay(record).after(i);
            CHECK(state.candidates.size() >= known);
            known = state.candidates.size();
            const auto crossed = static_cast<std::size_t>(std::count_if(
                state.candidates.begin(), state.candidates.end(),
                [](const CandidateMark& m) { return m.state == CandidateState::Rejected; }));
            CHECK(crossed >= rejected);
            rejected = crossed;
        }
        ever += rejected;
    }
    CHECK(ever > 0);
}

TEST_CASE("A seed shows a ring of two, and the pivot its first and last") {
    Timeline timeline(test::sceneNamed("sphere"), Params{});
    const auto record = timeline.record(1);
    const DecisionState seed = PivotReplay(record).after(indexOf(*record, Stage::Seed));
    REQUIRE(seed.rings.size() == 1);
    CHECK(seed.rings[0].points.size() == 2);
    CHECK(seed.rings[0].active);
    CHECK(seed.pivot == kNone);
    const DecisionState pivot = PivotReplay(record).after(indexOf(*record, Stage::Pivot));
    CHECK(pivot.pivot != kNone);
    CHECK(pivot.first == pivot.last);
    CHECK(pivot.sectorDegrees == doctest::Approx(360.0));
}

TEST_CASE("The stack shows its top first, as the state has it") {
    Timeline timeline(test::sceneNamed("torus"), Params{});
    bool seen = false;
    for (std::uint32_t pivot = 10; pivot < 700 && !seen; pivot += 10) {
        const auto record = timeline.record(pivot);
        const RunState& state = record->after;
        if (state.rings.stack().empty() || state.rings.active() == kNone) continue;
        seen = true;
        const std::vector<RingPath> paths = ringPaths(state.rings);
        REQUIRE(paths.size() == state.rings.stack().size() + 1);
        CHECK(paths[0].active);
        CHECK(paths[1].id == state.rings.stack().back());
        CHECK(paths[1].points.size() == state.rings.length(paths[1].id));
    }
    CHECK(seen);
}

TEST_CASE("The state before an event is that after the event before it") {
    Timeline timeline(test::sceneNamed("sphere"), Params{});
    const auto record = timeline.record(30);
    const std::size_t emit = indexOf(*record, Stage::Emit);
    CHECK(PivotReplay(record).before(emit).newTriangles.empty());
    CHECK(PivotReplay(record).before(emit + 1).newTriangles.size() == 1);
    CHECK(PivotReplay(record).after(emit + 1).newTriangles.size() == 2);
    const DecisionState first = PivotReplay(record).before(0);
    CHECK_FALSE(first.event.has_value());
    CHECK(first.pivot == kNone);
    CHECK(first.status == record->before.status);
}

TEST_CASE("The end of a run has as many triangles as its mesh") {
    int edited = 0;
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        CAPTURE(seed);
        Timeline timeline(test::randomPoints(seed), *paramsByName("robust"));
        timeline.seek(std::numeric_limits<std::uint32_t>::max());
        const auto record = timeline.record(timeline.lastPivot());
        const DecisionState state = PivotReplay(record).after(record->events.size() - 1);
        const std::size_t triangles = timeline.state().mesh().size();
        edited += triangles != timeline.state().triangles.size() ? 1 : 0;
        CHECK(state.finishedTriangles + state.newTriangles.size() == triangles);
    }
    CHECK(edited > 0);
}

TEST_CASE("After the last pivot, triangles with only rotated corners are not new") {
    const std::vector<Triangle> before = {{0, 1, 2}, {2, 1, 3}};
    const std::vector<Triangle> after = {{1, 2, 0}, {2, 1, 4}};
    const std::vector<Triangle> fresh = freshTriangles(before, after);
    REQUIRE(fresh.size() == 1);
    CHECK(fresh[0] == Triangle{2, 1, 4});
}
