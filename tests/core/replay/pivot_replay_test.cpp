#include "run/picture.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "open_session.h"

using namespace se;
using namespace se::view;

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

}  // namespace

TEST_CASE("The last event of every pivot shows the state after it") {
    for (const char* scene : {"scene:sphere", "scene:torus", "scene:sheet"}) {
        CAPTURE(scene);
        LoadProgress progress;
        const auto model = test::loadModel({scene, {}, "paper"}, progress);
        REQUIRE(model.ok());
        Timeline timeline(model.value()->points, model.value()->params);
        for (std::uint32_t pivot = 1; pivot <= 200; pivot += 7) {
            const auto record = recordPivot(timeline, pivot);
            const Picture picture = makePicture(*record, record->events.size() - 1);
            CHECK(picture.complete);
            CHECK(picture.status == record->after.status);
            CHECK(picture.finishedTriangles + picture.newTriangles.size() ==
                  record->after.triangleCount);
        }
    }
}

TEST_CASE("Ring events change the ring one by one into that after the pivot") {
    const auto model = test::sphereModel();
    REQUIRE(model != nullptr);
    Timeline timeline(model->points, model->params);
    int compared = 0;
    for (std::uint32_t pivot = 1; pivot <= 150; ++pivot) {
        const auto record = recordPivot(timeline, pivot);
        const bool plain = indexOf(*record, Stage::Split) == record->events.size() &&
                           indexOf(*record, Stage::Join) == record->events.size() &&
                           indexOf(*record, Stage::Done) == record->events.size();
        const std::size_t advance = indexOf(*record, Stage::Advance);
        if (!plain || advance == 0 || record->events[advance - 1].address.stage != Stage::Ring)
            continue;
        const Picture before = makePicture(*record, advance - 1);
        const Picture after = makePicture(*record, advance);
        REQUIRE_FALSE(before.rings.empty());
        REQUIRE_FALSE(after.rings.empty());
        CAPTURE(pivot);
        CHECK(cycle(before.rings[0].points) == cycle(after.rings[0].points));
        ++compared;
    }
    CHECK(compared > 60);
}

TEST_CASE("Triangles appear one by one") {
    const auto model = test::sphereModel();
    REQUIRE(model != nullptr);
    Timeline timeline(model->points, model->params);
    const auto record = recordPivot(timeline, 30);
    const std::size_t emit = indexOf(*record, Stage::Emit);
    REQUIRE(emit < record->events.size());
    CHECK(makePicture(*record, emit - 1).newTriangles.empty());
    CHECK(makePicture(*record, emit).newTriangles.size() == 1);
    CHECK(makePicture(*record, emit + 1).newTriangles.size() == 2);
}

TEST_CASE("Candidates are marked from their first test on, and stay crossed once rejected") {
    const auto model = test::sphereModel();
    REQUIRE(model != nullptr);
    Timeline timeline(model->points, model->params);
    for (std::uint32_t pivot = 1; pivot <= 60; ++pivot) {
        const auto record = recordPivot(timeline, pivot);
        std::size_t known = 0;
        std::size_t rejected = 0;
        for (std::size_t i = 0; i < record->events.size(); ++i) {
            const Picture picture = makePicture(*record, i);
            CHECK(picture.candidates.size() >= known);
            known = picture.candidates.size();
            const auto crossed = static_cast<std::size_t>(std::count_if(
                picture.candidates.begin(), picture.candidates.end(),
                [](const CandidateMark& m) { return m.state == CandidateState::Rejected; }));
            CHECK(crossed >= rejected);
            rejected = crossed;
        }
    }
}

TEST_CASE("A seed shows a ring of two, and the pivot its first and last") {
    const auto model = test::sphereModel();
    REQUIRE(model != nullptr);
    Timeline timeline(model->points, model->params);
    const auto record = recordPivot(timeline, 1);
    const Picture seed = makePicture(*record, indexOf(*record, Stage::Seed));
    REQUIRE(seed.rings.size() == 1);
    CHECK(seed.rings[0].points.size() == 2);
    CHECK(seed.rings[0].active);
    CHECK(seed.pivot == kNone);
    const Picture pivot = makePicture(*record, indexOf(*record, Stage::Pivot));
    CHECK(pivot.pivot != kNone);
    CHECK(pivot.first == pivot.last);
    CHECK(pivot.sectorDegrees == doctest::Approx(360.0));
}

TEST_CASE("The stack shows its top first, as the state has it") {
    LoadProgress progress;
    const auto model = test::loadModel({"scene:torus", {}, "paper"}, progress);
    REQUIRE(model.ok());
    Timeline timeline(model.value()->points, model.value()->params);
    bool seen = false;
    for (std::uint32_t pivot = 10; pivot < 700 && !seen; pivot += 10) {
        const auto record = recordPivot(timeline, pivot);
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

TEST_CASE("The picture before an event is that of the event before it") {
    const auto model = test::sphereModel();
    REQUIRE(model != nullptr);
    Timeline timeline(model->points, model->params);
    const auto record = recordPivot(timeline, 30);
    const std::size_t emit = indexOf(*record, Stage::Emit);
    CHECK(makePictureBefore(*record, emit).newTriangles.empty());
    CHECK(makePictureBefore(*record, emit + 1).newTriangles.size() == 1);
    const Picture first = makePictureBefore(*record, 0);
    CHECK_FALSE(first.event.has_value());
    CHECK(first.pivot == kNone);
    CHECK(first.status == record->before.status);
}

TEST_CASE("Holding the look before an event changes the picture, not the cursor") {
    test::OpenSession open;
    open.session.moves().goTo({30, Stage::Emit, 1});
    open.session.waitUntilDone();
    open.session.showBefore(true);
    CHECK(open.session.picture().newTriangles.empty());
    CHECK(open.place() == "30.emit.1");
    open.session.showBefore(false);
    CHECK(open.session.picture().newTriangles.size() == 1);
}

TEST_CASE("A refused candidate keeps its cross until the pivot ends") {
    const auto model = test::sphereModel();
    REQUIRE(model != nullptr);
    Timeline timeline(model->points, model->params);
    const auto record = recordPivot(timeline, 30);
    const auto crosses = [&](std::size_t cursor) {
        const Picture picture = makePicture(*record, cursor);
        return std::count_if(
            picture.candidates.begin(), picture.candidates.end(),
            [](const CandidateMark& m) { return m.state == CandidateState::Rejected; });
    };
    const std::size_t emit = indexOf(*record, Stage::Emit);
    REQUIRE(crosses(emit) > 0);
    CHECK(crosses(record->events.size() - 2) == crosses(emit));
}
