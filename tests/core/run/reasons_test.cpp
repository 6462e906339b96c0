/// The reasons in the sentences of decisions, recomputed from the points and the other decisions of
/// their pivots.
#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <map>

#include "spiraling_edge/run/event_text.h"
#include "spiraling_edge/run/reading.h"
#include "spiraling_edge/run/sweep.h"
#include "spiraling_edge/scenes/scenes.h"
#include "support/clouds.h"
#include "support/rig.h"

using namespace se;
using namespace se::test;

namespace {

/// Calls visit(points, pivot) with the pivots of all scenes under three rule sets.
template <typename Visit>
void forEachPivot(const Visit& visit) {
    const auto run = [&](const Scene& scene) {
        CAPTURE(scene.id);
        const PointSet points = prepared(scene.build());
        for (const Params& params : {paper(), *paramsByName("corrected"), robust()})
            sweep(points, params, [&](const SweptPivot& pivot) { visit(points, pivot); });
    };
    for (const Scene& scene : scenes()) {
        if (scene.start == nullptr) run(scene);
    }
    for (const FailureScene& each : failureScenes()) run(each.scene);
}

bool says(const Event& event, std::string_view words) {
    return describe(event).find(words) != std::string::npos;
}

}  // namespace

TEST_CASE(
    "reasons: what the convexity test drops is named by why start or end did not move there") {
    std::map<Verdict, std::size_t> seen;
    forEachPivot([&](const PointSet&, const SweptPivot& pivot) {
        std::array<Verdict, 2> stayed{Verdict::NotAnEdge, Verdict::NotAnEdge};
        for (const Event& event : pivot.events) {
            if (const auto* limit = as<LimitEvidence>(event))
                stayed[static_cast<std::size_t>(limit->side)] = limit->verdict;
            const auto* drop = as<DropEvidence>(event);
            if (drop == nullptr || event.address.stage != Stage::Convex) continue;
            const Verdict why = stayed[static_cast<std::size_t>(drop->side)];
            ++seen[drop->verdict];
            CAPTURE(describe(event));
            CHECK((drop->verdict == Verdict::BeyondConvex) == (why == Verdict::NotConcave));
            CHECK((drop->verdict == Verdict::BeyondHalfTurn) == (why == Verdict::HalfTurn));
            CHECK((drop->verdict == Verdict::BeyondBlocked) == (why == Verdict::Blocked));
            CHECK(says(event, "convex") == (why == Verdict::NotConcave));
            CHECK(says(event, "180 degrees") == (why == Verdict::HalfTurn));
            CHECK(says(event, "UNUSED") == (why == Verdict::Blocked));
        }
    });
    for (const Verdict each :
         {Verdict::BeyondConvex, Verdict::BeyondHalfTurn, Verdict::BeyondBlocked}) {
        CAPTURE(verdictText(each));
        CHECK(seen[each] > 0);
    }
}

TEST_CASE("reasons: inside, outside and on the sphere are told by distance and radius") {
    std::size_t on = 0;
    std::size_t off = 0;
    forEachPivot([&](const PointSet& points, const SweptPivot& pivot) {
        for (const Event& event : pivot.events) {
            const auto* sphere = as<SphereEvidence>(event);
            if (sphere == nullptr || !hasSphere(*sphere)) continue;
            const double r = glm::distance(points.position[pivot.point], sphere->center);
            const double d = glm::distance(points.position[sphere->q], sphere->center) - r;
            if (says(event, "on the sphere")) {
                ++on;
                CHECK(std::abs(d) <= 1e-9 * r);
            } else if (says(event, " inside the sphere") || says(event, " outside the sphere")) {
                ++off;
                CHECK(says(event, " inside the sphere") == (d < 0.0));
                CHECK(std::abs(d) > 1e-13 * r);
            }
        }
    });
    CHECK(on > 0);
    CHECK(off > 1000);
}

TEST_CASE("reasons: first and last are said to be one point where they are") {
    std::size_t seen = 0;
    forEachPivot([&](const PointSet&, const SweptPivot& pivot) {
        const PivotEvidence* begun = nullptr;
        for (const Event& event : pivot.events) {
            if (const auto* at = as<PivotEvidence>(event)) begun = at;
            if (!isA<TwoPointEvidence>(event) || begun == nullptr) continue;
            if (!says(event, "they are one point")) continue;
            ++seen;
            CHECK(begun->first == begun->last);
        }
    });
    CHECK(seen > 0);
}
