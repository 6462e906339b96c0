#include <doctest/doctest.h>

#include <algorithm>
#include <functional>
#include <string>

#include "spiraling_edge/doctor/doctor.h"
#include "spiraling_edge/mesh/inspection.h"
#include "spiraling_edge/run/timeline.h"
#include "spiraling_edge/scenes/scenes.h"
#include "spiraling_edge/why/ledger.h"
#include "support/clouds.h"
#include "support/rig.h"

using namespace se;
using namespace se::test;

namespace {

const FailureScene& galleryScene(std::string_view id) {
    const auto all = failureScenes();
    const auto found = std::find_if(all.begin(), all.end(),
                                    [&](const FailureScene& each) { return each.scene.id == id; });
    REQUIRE(found != all.end());
    return *found;
}

std::size_t failuresIn(const PointSet& points, const Params& params, std::string_view name) {
    const Run run = runAll(points, params);
    const auto failures = inspectMesh(points, run.state.mesh());
    return static_cast<std::size_t>(
        std::count_if(failures.begin(), failures.end(),
                      [&](const MeshFailure& each) { return each.kind->name == name; }));
}

Event eventAt(const PointSet& points, std::string_view address) {
    const auto wanted = addressFromString(address);
    REQUIRE(wanted);
    Timeline timeline(points, paper());
    const auto record = timeline.record(wanted->pivot);
    for (const Event& event : record->events) {
        if (event.address == *wanted) return event;
    }
    FAIL("there is no event at " << address);
    return {};
}

template <typename E>
E evidenceAt(const char* scene) {
    const FailureScene& each = galleryScene(scene);
    const Event event = eventAt(prepared(each.scene.build()), each.address);
    REQUIRE(std::holds_alternative<E>(event.evidence));
    return std::get<E>(event.evidence);
}

/// The number of failures of its class with other rules or another input.
std::size_t leftIn(const char* scene, const char* rules,
                   const std::function<void(PointFile&)>& change = {},
                   const PrepareOptions& options = {}) {
    const FailureScene& each = galleryScene(scene);
    PointFile file = each.scene.build();
    if (change) change(file);
    const auto made = prepare(file, options);
    REQUIRE(made.ok());
    return failuresIn(made.value().points, *paramsByName(rules), each.failure);
}

}  // namespace

TEST_CASE("gallery: every scene ends in its failure, and has a decision at its address") {
    for (const FailureScene& each : failureScenes()) {
        CAPTURE(each.scene.id);
        CHECK(findScene(each.scene.id) == &each.scene);
        CHECK(findFailureClass(each.failure) != nullptr);
        const PointSet points = prepared(each.scene.build());
        REQUIRE(points.size() > 0);
        CHECK(points.size() < 700);
        CHECK(failuresIn(points, paper(), each.failure) > 0);
        eventAt(points, each.address);
        for (const std::string_view text : {each.scene.watch, each.sentence, each.helps})
            CHECK_FALSE(text.empty());
    }
}

TEST_CASE("gallery: four-edge-hole keeps a point behind a hole of four, which 6.2 does not see") {
    const auto e = evidenceAt<SphereEvidence>("four-edge-hole");
    CHECK(e.verdict == Verdict::GapTooWide);
    CHECK(leftIn("four-edge-hole", "corrected") == 0);
}

TEST_CASE("gallery: what helps, helps") {
    CHECK(leftIn("sparse-spot", "robust") == 0);
    CHECK(leftIn("sharp-crease", "robust") == 0);
    CHECK(leftIn("uneven-density", "robust") == 0);
    CHECK(leftIn("noise", "robust") == 0);
    const auto newLists = [](PointFile& file) { file.neighbors = {}; };
    CHECK(leftIn("wrong-lists", "paper", newLists) == 0);
    CHECK(leftIn("sparse-spot", "paper", newLists) <= 1);
    CHECK(leftIn("stranded-point", "corrected") == 0);
    PrepareOptions orient;
    orient.normals = NormalSource::Oriented;
    CHECK(leftIn("flipped-patch", "paper", {}, orient) == 0);
    const auto dropCopies = [](PointFile& file) {
        const auto diagnosis = examine(file);
        REQUIRE(diagnosis.ok());
        for (const Finding& finding : diagnosis.value().findings) {
            if (finding.check->name == "near_duplicates")
                file = applyFixes(file, finding.points).file;
        }
    };
    CHECK(leftIn("near-duplicates", "paper", dropCopies) <= 1);
}

TEST_CASE("gallery: the decisions match the scenes") {
    CHECK(evidenceAt<TwoPointEvidence>("sparse-spot").verdict == Verdict::Discarded);
    CHECK(evidenceAt<LimitEvidence>("uneven-density").verdict == Verdict::Moved);
    CHECK(evidenceAt<LimitEvidence>("tee-at-wall").verdict == Verdict::Moved);
    CHECK(evidenceAt<ReciprocalEvidence>("wrong-lists").verdict == Verdict::Kept);
    CHECK_FALSE(evidenceAt<StrandEvidence>("stranded-point").isolated);
    CHECK(evidenceAt<SphereEvidence>("near-duplicates").verdict == Verdict::InsideSphere);
    const PointSet sheets = prepared(galleryScene("close-sheets").scene.build());
    const auto t = evidenceAt<InsertEvidence>("close-sheets");
    CHECK(t.corner);
    CHECK_FALSE(sheets.position[t.pivot].z == sheets.position[t.third].z);
    const PointSet flipped = prepared(galleryScene("flipped-patch").scene.build());
    const Triangle f = evidenceAt<EmitEvidence>("flipped-patch").corners;
    // The pivot is one of the cap.
    CHECK(glm::dot(flipped.normal[f.a], flipped.position[f.a]) < 0.0);
}
