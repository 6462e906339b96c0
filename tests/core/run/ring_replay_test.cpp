#include "spiraling_edge/run/ring_replay.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <string>

#include "spiraling_edge/run/timeline.h"
#include "support/clouds.h"
#include "support/rule_values.h"

using namespace se;

namespace {

bool same(const std::vector<RingPath>& a, const std::vector<RingPath>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const auto& x, const auto& y) {
        return x.points == y.points && x.open == y.open && x.active == y.active && x.id == y.id;
    });
}

/// Compares the replayed rings with the actual ones.
struct Followed {
    int pivots = 0;
    int splits = 0;
    int joins = 0;
    int several = 0;  ///< Pivots with more than one of them.
};

Followed follow(const char* scene, const Params& params, std::uint32_t last) {
    CAPTURE(scene);
    Timeline timeline(test::sceneNamed(scene), params);
    Followed seen;
    for (std::uint32_t pivot = 1; pivot <= last; ++pivot) {
        const auto record = timeline.record(pivot);
        if (record->pivot != pivot) break;
        CAPTURE(pivot);
        RingReplay replay(record->before.rings, timeline.points().size(), record->rules);
        int exchanges = 0;
        for (const Event& event : record->events) {
            if (event.address.stage == Stage::Advance) break;
            replay.apply(event);
            if (const auto* split = std::get_if<SplitEvidence>(&event.evidence)) {
                ++seen.splits;
                ++exchanges;
                REQUIRE(replay.exchange().has_value());
                CHECK(replay.exchange()->a.points.size() == split->activeLength);
                CHECK(replay.exchange()->b.points.size() == split->stackedLength);
                CHECK(replay.rings().stack().size() == split->stackDepth);
            } else if (const auto* join = std::get_if<JoinEvidence>(&event.evidence)) {
                ++seen.joins;
                ++exchanges;
                REQUIRE(replay.exchange().has_value());
                const RingExchange& loops = *replay.exchange();
                CHECK(loops.a.points.size() + loops.b.points.size() == join->length);
            }
        }
        CHECK_FALSE(replay.lost());
        ++seen.pivots;
        if (exchanges > 1) ++seen.several;
        // The end of a pivot without triangles takes a third point of §7 back, and the next ring
        // comes off the stack: no event reports that.
        const EdgeRings& after = record->after.rings;
        const bool made = record->after.triangleCount > record->before.triangleCount;
        if (!made || after.active() == kNone || after.active() != replay.rings().active()) continue;
        CHECK(same(ringPaths(replay.rings()), ringPaths(after)));
    }
    return seen;
}

/// Splits and joins of three scenes by some rules.
Followed followScenes(const Params& params) {
    Followed all;
    for (const char* scene : {"torus", "figure-12", "linked-tori"}) {
        const Followed seen = follow(scene, params, 400);
        all.splits += seen.splits;
        all.joins += seen.joins;
    }
    return all;
}

}  // namespace

TEST_CASE("Replayed by its events, every pivot ends with the rings of the run") {
    Followed all;
    for (const char* rules : {"paper", "robust"}) {
        for (const char* scene : {"sphere", "torus", "genus-2", "sheet", "figure-12", "figure-14",
                                  "linked-tori", "finished-edge"}) {
            CAPTURE(rules);
            const Followed seen = follow(scene, paramsByName(rules).value(), 1200);
            all.pivots += seen.pivots;
            all.splits += seen.splits;
            all.joins += seen.joins;
            all.several += seen.several;
        }
    }
    CHECK(all.pivots > 3000);
    CHECK(all.splits > 10);
    CHECK(all.joins > 2);
    CHECK(all.several > 0);
}

TEST_CASE("Replayed rings split and join by the rules of the run") {
    for (const char* rule :
         {"active=other", "active=longer", "active=shorter", "instance=first", "reciprocal=off"}) {
        CAPTURE(rule);
        Params params;
        const RuleValue value = ruleValueFromText(rule).value();
        REQUIRE(applyRuleValues({&value, 1}, params).ok());
        CHECK(followScenes(params).splits > 3);
    }
}

TEST_CASE("Replayed rings split and join by every value of a rule of the paper" *
          doctest::test_suite("long")) {
    Followed all;
    test::forEachPaperRule(Params(), [&](const Params& params, const std::string& rule) {
        CAPTURE(rule);
        const Followed seen = followScenes(params);
        all.splits += seen.splits;
        all.joins += seen.joins;
    });
    CHECK(all.splits > 100);
    CHECK(all.joins > 20);
}

TEST_CASE("Where no ring is active, all of them are stacked") {
    std::vector<RingPath> rings(3);
    CHECK(stackedCount(rings) == 3);
    rings[0].active = true;
    CHECK(stackedCount(rings) == 2);
    CHECK(stackedCount({}) == 0);
}
