#include "spiraling_edge/failure_moments.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <tuple>

#include "../support/clouds.h"
#include "../support/rig.h"
#include "spiraling_edge/scenes.h"

using namespace se;
using namespace se::test;

namespace {

FailureMoments momentsIn(const PointSet& points, const Params& params, const MeshFailure& failure,
                         const std::vector<Triangle>& mesh) {
    const auto moments = momentsOf(points, params, failure, mesh);
    REQUIRE(moments.ok());
    return moments.value();
}

/// The failure of this class whose decision is the one that the gallery names.
bool leadsTo(const FailureScene& each) {
    const PointSet points = prepared(each.scene.build());
    const Run run = runAll(points, paper());
    for (const MeshFailure& failure : inspectMesh(points, run.state.mesh())) {
        if (failure.kind->name != each.failure) continue;
        const FailureMoments moments = momentsIn(points, paper(), failure, run.state.mesh());
        const std::uint32_t pivot = addressFromString(each.address)->pivot;
        const auto& at = moments.unavoidable.event.address;
        if (toString(at) == each.address || at.pivot == pivot ||
            moments.created.event.address.pivot == pivot)
            return true;
    }
    return false;
}

}  // namespace

TEST_CASE("moments: in the gallery they lead to the planted cause") {
    for (const FailureScene& each : failureScenes()) {
        CAPTURE(each.scene.id);
        CHECK(leadsTo(each));
    }
}

TEST_CASE("moments: touched first, then unavoidable, then created") {
    for (const char* set : {"paper", "robust"}) {
        const Params params = *paramsByName(set);
        for (const FailureScene& each : failureScenes()) {
            CAPTURE(set);
            CAPTURE(each.scene.id);
            const PointSet points = prepared(each.scene.build());
            const Run run = runAll(points, params);
            std::size_t asked = 0;
            for (const MeshFailure& failure : inspectMesh(points, run.state.mesh())) {
                if (++asked > (kSanitized ? 5U : 40U)) break;
                CAPTURE(describe(failure));
                const FailureMoments moments = momentsIn(points, params, failure, run.state.mesh());
                const auto pivot = [](const LedgerLine& line) { return line.event.address.pivot; };
                CHECK(pivot(moments.touched) <= pivot(moments.unavoidable));
                CHECK(pivot(moments.unavoidable) <= pivot(moments.created));
            }
        }
    }
}

TEST_CASE("moments: the hole of four was made by the point that was kept behind it") {
    const FailureScene& each = failureScenes()[0];
    REQUIRE(each.scene.id == "four-edge-hole");
    const PointSet points = prepared(each.scene.build());
    const Run run = runAll(points, paper());
    for (const MeshFailure& failure : inspectMesh(points, run.state.mesh())) {
        if (failure.kind->name != each.failure || failure.triangles.back() != 315) continue;
        const FailureMoments moments = momentsIn(points, paper(), failure, run.state.mesh());
        CHECK(toString(moments.created.event.address) == "81.emit.1");
        CHECK(toString(moments.unavoidable.event.address) == each.address);
        CHECK(testedPoint(moments.unavoidable.event) == 50);
    }
}

TEST_CASE("moments: a failure of another mesh, and a reader who cancels") {
    const PointSet points = prepared(failureScenes()[0].scene.build());
    const Run run = runAll(points, paper());
    const auto failures = inspectMesh(points, run.state.mesh());
    REQUIRE_FALSE(failures.empty());
    CHECK_FALSE(momentsOf(points, paper(), failures[0], {}).ok());
    CHECK_FALSE(momentsOf(points, paper(), failures[0], run.state.mesh(), [](double) {
                    return false;
                }).ok());
}
