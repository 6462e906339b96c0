#include "spiraling_edge/run/ring_lanes.h"

#include <doctest/doctest.h>

#include "jobs/runner.h"
#include "open_session.h"
#include "rows/lane_picture.h"
#include "spiraling_edge/scenes/scenes.h"
#include "spiraling_edge/stepper/stepper.h"

using namespace se;
using namespace se::view;

namespace {

std::shared_ptr<const Model> modelOf(const std::string& source, const std::string& rules) {
    LoadProgress progress;
    const auto loaded = test::loadModel(withSet({source}, rules), progress);
    return loaded ? loaded.value() : nullptr;
}

Event eventOf(std::uint32_t pivot, Stage stage, const Evidence& evidence) {
    return {{pivot, stage, 1}, evidence};
}

/// A seed; at pivot 3 a split; at pivot 5 a join; at pivot 6 the ring closes.
RunOverview shortRun() {
    LaneTracker keeper;
    keeper.take(eventOf(1, Stage::Seed, SeedEvidence{0, 1, 1.0}));
    keeper.take(eventOf(3, Stage::Pivot, PivotEvidence{0, 1, 2, 10, 90.0}));
    keeper.take(eventOf(3, Stage::Split, SplitEvidence{4, 6, 4, 1}));
    keeper.take(eventOf(5, Stage::Pivot, PivotEvidence{0, 1, 2, 6, 90.0}));
    keeper.take(eventOf(5, Stage::Join, JoinEvidence{4, 0, 10}));
    keeper.take(eventOf(6, Stage::Pivot, PivotEvidence{0, 1, 2, 2, 90.0}));
    keeper.take(eventOf(6, Stage::Ring, CloseEvidence{1, 2}));
    RunOverview run;
    run.laneChanges = keeper.takeChanges();
    run.lanes = 2;
    run.lastPivot = 10;
    run.ringLength = {2, 4, 6, 6, 10, 0, 0, 0, 0, 0};
    run.longestRing = 10;
    return run;
}

}  // namespace

TEST_CASE("The overview has the lanes at any pivot") {
    const auto model = modelOf("scene:torus", "paper");
    REQUIRE(model != nullptr);
    Runner runner(model);
    runner.waitUntilMade();
    RunOverview run;
    REQUIRE(runner.takeOverview(run));
    CHECK(run.lanes >= 2);
    std::size_t wrong = 0;
    for (std::uint32_t pivot = 1; pivot <= run.ringLength.size(); ++pivot) {
        const std::uint32_t active = run.ringLength[pivot - 1] > 0 ? 1 : 0;
        if (lanesAt(run.laneChanges, pivot) != active + run.stackDepth[pivot - 1]) ++wrong;
    }
    CHECK(wrong == 0);
}

TEST_CASE("Lanes are drawn from where they begin to where they end") {
    const RunOverview run = shortRun();
    StripWindow window;
    window.setLast(run.lastPivot);
    const LanePicture picture = makeLanePicture(run, window, {100.0F, 4, 1.0F});
    CHECK(picture.rows == 2);
    CHECK(picture.gathered == 0);
    CHECK(picture.crowd.empty());
    REQUIRE(picture.bars.size() == 2);
    const LaneBar& stacked = picture.bars[0].active ? picture.bars[1] : picture.bars[0];
    const LaneBar& active = picture.bars[0].active ? picture.bars[0] : picture.bars[1];
    CHECK(active.from == doctest::Approx(0.0F));
    CHECK(active.to == doctest::Approx(60.0F));
    CHECK(stacked.row == 1);
    CHECK(stacked.from == doctest::Approx(30.0F));
    CHECK(stacked.to == doctest::Approx(50.0F));
    REQUIRE(picture.signs.size() == 4);
    CHECK(picture.signs[2].kind == LaneChangeKind::Join);
    CHECK(picture.signs[2].otherRow == 0);
    CHECK(picture.ringLength.size() == 100);
    CHECK(picture.ringLength[45] == doctest::Approx(1.0F));
}

TEST_CASE("Where there are more lanes than rows, the last row gathers the rest") {
    const RunOverview run = shortRun();
    StripWindow window;
    window.setLast(run.lastPivot);
    const LanePicture picture = makeLanePicture(run, window, {100.0F, 1, 1.0F});
    CHECK(picture.gathered == 2);
    CHECK(picture.rows == 1);
    REQUIRE(picture.bars.size() == 1);
    CHECK(picture.bars[0].active);
    CHECK(picture.bars[0].to == doctest::Approx(60.0F));
    REQUIRE(picture.crowd.size() == 100);
    CHECK(picture.crowd[10] == 1);
    CHECK(picture.crowd[40] == 2);
    CHECK(picture.crowd[55] == 1);
    CHECK(picture.crowd[80] == 0);
}

TEST_CASE("Lanes that share a row are counted by time, not in total") {
    RunOverview run;
    run.lanes = 12;
    run.lastPivot = 10'000;
    for (std::uint32_t lane = 0; lane < 12; ++lane)
        run.laneChanges.push_back({1, lane, 0, lane + 1, LaneChangeKind::Split});
    // Lane 11 ends and begins repeatedly within a pixel.
    for (std::uint32_t pivot = 100; pivot < 9'000; pivot += 2) {
        run.laneChanges.push_back({pivot, 11, 0, 11, LaneChangeKind::Join});
        run.laneChanges.push_back({pivot + 1, 11, 0, 12, LaneChangeKind::Split});
    }
    StripWindow window;
    window.setLast(run.lastPivot);
    const LanePicture picture = makeLanePicture(run, window, {200.0F, 5, 8.0F});
    CHECK(picture.rows == 5);
    CHECK(picture.gathered == 8);  // 12 less the four that have a row of their own
    REQUIRE(picture.crowd.size() == 200);
    for (std::size_t c = 0; c < 200; ++c) CHECK(picture.crowd[c] == 8);
    for (const LaneBar& bar : picture.bars) CHECK(bar.row < 4);
    for (const LaneSign& sign : picture.signs) CHECK(sign.row < 4);
}

TEST_CASE("The number of shapes depends on the pixels, not on the length of the run") {
    RunOverview run;
    run.lanes = 2;
    run.lastPivot = 1'000'000;
    run.laneChanges.push_back({1, 0, 0, 1, LaneChangeKind::Seed});
    for (std::uint32_t pivot = 10; pivot + 5 < run.lastPivot; pivot += 10) {
        run.laneChanges.push_back({pivot, 1, 0, 2, LaneChangeKind::Split});
        run.laneChanges.push_back({pivot + 5, 1, 0, 1, LaneChangeKind::Join});
    }
    StripWindow window;
    window.setLast(run.lastPivot);
    const LanePicture picture = makeLanePicture(run, window, {1000.0F, 8, 8.0F});
    CHECK(picture.bars.size() <= 2 * 1000 + 2);
    CHECK(picture.signs.size() <= 1000);
}

TEST_CASE("An alert near the pointer is named, with its point and pivot") {
    RunOverview run = shortRun();
    run.marks.push_back({4, MarkKind::Alert, 2, {AlertKind::Hole, 17}});
    StripWindow window;
    window.setLast(run.lastPivot);
    const LanePicture picture = makeLanePicture(run, window, {100.0F, 4, 1.0F});
    REQUIRE(picture.alerts.size() == 1);
    const float x = picture.alerts[0].x;
    CHECK(alertNear(picture, x + 20.0F, 8.0F) == nullptr);
    const LaneAlert* found = alertNear(picture, x + 3.0F, 8.0F);
    REQUIRE(found != nullptr);
    const std::string text = alertText(*found);
    CHECK(text.find("hole") != std::string::npos);
    CHECK(text.find("point 17") != std::string::npos);
    CHECK(text.find("pivot 4") != std::string::npos);
}

TEST_CASE("The strip's window zooms about a position and stays within the run") {
    StripWindow window;
    window.setLast(1000);
    CHECK(window.whole());
    CHECK(window.shareOf(250) == doctest::Approx(0.25));
    window.zoomAt(0.25, 4.0);
    CHECK_FALSE(window.whole());
    CHECK(window.pivotAt(0.25) == doctest::Approx(250.0));
    CHECK(window.to() - window.from() < 500.0);
    window.pan(-100.0);
    CHECK(window.from() == doctest::Approx(0.0));
    window.pan(100.0);
    CHECK(window.to() == doctest::Approx(1000.0));
    window.zoomAt(1.0, 200.0);
    CHECK(window.to() - window.from() == doctest::Approx(StripWindow::kLeast));
    window.reveal(10);
    CHECK(window.shareOf(10) >= 0.0);
    CHECK(window.shareOf(10) <= 1.0);
    window.zoomAt(0.5, -200.0);
    CHECK(window.whole());
    window.setLast(2000);
    CHECK(window.to() == doctest::Approx(2000.0));
}
