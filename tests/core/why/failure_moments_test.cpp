#include "spiraling_edge/why/failure_moments.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <limits>
#include <tuple>

#include "spiraling_edge/run/timeline.h"
#include "spiraling_edge/sampling/field.h"
#include "spiraling_edge/sampling/sampler.h"
#include "spiraling_edge/scenes/scenes.h"
#include "support/clouds.h"
#include "support/rig.h"
#include "support/subjects.h"

using namespace se;
using namespace se::test;

namespace {

/// The failure of this class whose decision is the one that the gallery names.
bool leadsTo(const FailureScene& each) {
    const std::vector<RunFailure> all = failuresOf(prepared(each.scene.build()), paper());
    for (const RunFailure& found : all) {
        if (found.failure.kind->name != each.failure) continue;
        const std::uint32_t pivot = addressFromString(each.address)->pivot;
        const auto& at = found.moments.decided.event.address;
        if (toString(at) == each.address || at.pivot == pivot ||
            found.moments.created.event.address.pivot == pivot)
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

TEST_CASE("moments: touched first, then decided, then created") {
    for (const char* set : {"paper", "robust"}) {
        const Params params = *paramsByName(set);
        for (const FailureScene& each : failureScenes()) {
            CAPTURE(set);
            CAPTURE(each.scene.id);
            const std::vector<RunFailure> all = failuresOf(prepared(each.scene.build()), params);
            for (const auto& [failure, position, corners, moments] : all) {
                CAPTURE(describe(failure));
                const auto pivot = [](const LedgerLine& line) { return line.event.address.pivot; };
                CHECK(pivot(moments.touched) <= pivot(moments.decided));
                CHECK(pivot(moments.decided) <= pivot(moments.created));
            }
        }
    }
}

TEST_CASE("moments: a cancelled search") {
    const PointSet points = prepared(failureScenes()[0].scene.build());
    for (const double end : {0.0, 0.5}) {
        const auto goOn = [&](double share) { return share < end; };
        CHECK_FALSE(searchFailures(points, paper(), goOn).ok());
    }
}

TEST_CASE("moments: the failures of a run are those of its mesh, in the same order") {
    for (const char* scene : {"four-edge-hole", "noise", "stranded-point"}) {
        CAPTURE(scene);
        const PointSet points = prepared(findScene(scene)->build());
        const Run run = runAll(points, paper());
        const std::vector<RunFailure> all = failuresOf(points, paper());
        const std::vector<MeshFailure> inMesh = inspectMesh(points, run.state.mesh());
        std::size_t next = 0;
        for (const RunFailure& each : all) {
            if (each.failure.kind->find == nullptr) continue;
            REQUIRE(next < inMesh.size());
            CHECK(each.failure.points == inMesh[next++].points);
        }
        CHECK(next == inMesh.size());
    }
}

TEST_CASE("moments: a ring that is left over is a failure of the run, with the points it had") {
    // Two points that list only each other: a seed without a third point.
    PointFile file;
    file.position = {{0, 0, 0}, {1, 0, 0}, {9, 0, 0}, {10, 0, 0}, {9, 1, 0}};
    file.normal.assign(5, Vec3(0, 0, 1));
    const std::vector<std::vector<Index>> lists{{1}, {0}, {3, 4}, {2, 4}, {2, 3}};
    for (const auto& list : lists) file.neighbors.append(list);
    const PointSet points = prepared(std::move(file));
    const std::vector<RunFailure> all = failuresOf(points, paperBut(&Readings::keepSeeds));
    const auto left = std::find_if(all.begin(), all.end(), [](const auto& each) {
        return each.failure.kind->name == "leftover_rings";
    });
    REQUIRE(left != all.end());
    CHECK(left->failure.points == std::vector<Index>{0, 1});
    CHECK(std::holds_alternative<FreeEvidence>(left->moments.created.event.evidence));
    CHECK(left->moments.touched.event.address.pivot <= left->moments.created.event.address.pivot);
}

TEST_CASE("moments: as many rings are left over as the run has alerts of them") {
    for (const FailureScene& each : failureScenes()) {
        CAPTURE(each.scene.id);
        const PointSet points = prepared(each.scene.build());
        const Run run = runAll(points, paper());
        const std::vector<RunFailure> all = failuresOf(points, paper());
        const auto rings = std::count_if(all.begin(), all.end(), [](const RunFailure& f) {
            return f.failure.kind->name == "leftover_rings";
        });
        CHECK(static_cast<std::size_t>(rings) == run.state.alerts.size());
    }
}

TEST_CASE("moments: a point that no test ever saw was lost with the last of its neighbors") {
    // The plane of a sheet, and a point above it that lists points of it, but is listed by none.
    PointFile file = findScene("grid")->build();
    const auto lone = static_cast<Index>(file.position.size());
    file.position.emplace_back(0.5, 0.5, 0.3);
    file.normal.emplace_back(0, 0, 1);
    file.type.push_back(kInterior);
    NeighborLists lists;
    const PointSet plain = prepared(findScene("grid")->build());
    for (Index p = 0; p < lone; ++p) lists.append(plain.neighbors[p]);
    const std::vector<Index> mine{40, 41, 49, 50};
    lists.append(mine);
    file.neighbors = std::move(lists);
    const PointSet points = prepared(std::move(file));
    const std::vector<RunFailure> all = failuresOf(points, paper());
    const auto lost = std::find_if(all.begin(), all.end(), [&](const auto& each) {
        return each.failure.points == std::vector<Index>{lone};
    });
    REQUIRE(lost != all.end());
    const auto* ring = std::get_if<RingEvidence>(&lost->moments.decided.event.evidence);
    REQUIRE(ring != nullptr);
    CHECK(ring->status < 0);
    CHECK(std::find(mine.begin(), mine.end(), ring->point) != mine.end());
    CHECK(std::holds_alternative<StrandEvidence>(lost->moments.created.event.evidence));
}

TEST_CASE("moments: every faulty triangle has a decision that it would not be there without") {
    for (const FailureScene& each : failureScenes()) {
        CAPTURE(each.scene.id);
        const PointSet points = prepared(each.scene.build());
        const std::vector<RunFailure> all = failuresOf(points, paper());
        for (const RunFailure& failure : all) {
            // Two corners that are the same point are no choice between candidates.
            if (failure.corners.empty() || failure.failure.kind->name == "degenerate_triangles")
                continue;
            CAPTURE(describe(failure.failure));
            CHECK_FALSE(
                std::holds_alternative<EmitEvidence>(failure.moments.decided.event.evidence));
        }
    }
}

TEST_CASE("moments: of a tangled run the first of each class are followed, the others counted" *
          doctest::test_suite("long")) {
    SamplerOptions options;
    options.count = 400;
    const PointFile file = sample(fieldOf(*findShape("torus")), options).value();
    const std::array kinds{reach(100), NeighborOptions{WithinRadius{1e300}}};
    for (const NeighborOptions& lists : kinds) {
        const PointSet points = prepared(file, lists);
        const auto found = searchFailures(points, paper());
        REQUIRE(found.ok());
        const std::vector<ClassTotal>& totals = found.value().verdict.totals;
        REQUIRE(totals.size() == failureClasses().size());
        CHECK_FALSE(isComplete(totals));
        std::size_t listed = 0;
        for (const ClassTotal& each : totals) {
            CHECK(each.listed <= each.total);
            CHECK((each.listed > 0) == (each.total > 0));
            listed += each.listed;
        }
        CHECK(listed == found.value().failures.size());
        CHECK(listed < 20000);
        const auto& last = found.value().failures.back();
        CHECK(last.failure.kind->name == "triangle_cap");
        if (&lists != &kinds[0]) continue;
        const auto again = searchFailures(points, paper());
        REQUIRE(again.ok());
        CHECK(std::equal(totals.begin(), totals.end(), again.value().verdict.totals.begin(),
                         [](const ClassTotal& a, const ClassTotal& b) {
                             return amountText(a) == amountText(b);
                         }));
    }
}

TEST_CASE("moments: of other runs all failures are followed") {
    const PointSet points = prepared(findScene("four-edge-hole")->build());
    const auto found = searchFailures(points, paper());
    REQUIRE(found.ok());
    CHECK(isComplete(found.value().verdict.totals));
    CHECK(found.value().failures.size() == failuresOfRun(points, paper()).value().size());
}

TEST_CASE("moments: of a stopped run, points and rings that were not DONE yet are no failures") {
    const PointSet points = prepared(closedFamilies(0.2)[0].sample(1));
    Params params = paper();
    params.maxTrianglesPerPoint = 1;
    const Run run = runAll(points, params);
    REQUIRE(run.stop == StopReason::Capped);
    REQUIRE(run.mesh.unusedPoints > 0);
    REQUIRE(run.mesh.boundaryLoops == 1);
    const auto found = searchFailures(points, params);
    REQUIRE(found.ok());
    for (std::size_t i = 0; i < failureClasses().size(); ++i) {
        CAPTURE(failureClasses()[i].name);
        const std::size_t expected = failureClasses()[i].name == "triangle_cap" ? 1 : 0;
        CHECK(found.value().verdict.totals[i].listed == expected);
        CHECK(found.value().verdict.totals[i].total == expected);
    }
    REQUIRE(found.value().failures.size() == 1);
    CHECK(found.value().failures[0].failure.kind->name == "triangle_cap");
}

TEST_CASE("moments: a run that was counted while it was made has the failures of one run again") {
    const PointSet points = sceneNamed("uneven-density");
    for (const char* rules : {"paper", "robust"}) {
        CAPTURE(rules);
        const Params params = paramsByName(rules).value();
        RunCounts counts(points);
        Timeline timeline(points, params);
        timeline.setVisitor([&](const SweptPivot& pivot) { counts.add(pivot); });
        timeline.seek(std::numeric_limits<std::uint32_t>::max());
        const std::vector<Triangle> mesh = timeline.state().mesh();
        const RunFailureSearch again = searchFailures(points, params).value();
        const RunFailureSearch made = searchFailures(points, params, counts, mesh).value();
        REQUIRE(made.failures.size() == again.failures.size());
        for (std::size_t i = 0; i < made.failures.size(); ++i) {
            CHECK(made.failures[i].failure.points == again.failures[i].failure.points);
            CHECK((made.failures[i].moments.decided.event.address ==
                   again.failures[i].moments.decided.event.address));
        }
        const RunFailureSearch atEnd = failuresAtEnd(points, counts, mesh);
        CHECK(atEnd.failures.empty());
        CHECK(atEnd.all.size() == again.all.size());
        CHECK(headlineOf(atEnd.verdict) == headlineOf(again.verdict));
        CHECK(atEnd.places.size() == again.places.size());
    }
}
