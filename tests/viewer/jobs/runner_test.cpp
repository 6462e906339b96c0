#include "jobs/runner.h"

#include <doctest/doctest.h>

#include <limits>

#include "open_session.h"
#include "spiraling_edge/run/reconstruct.h"

using namespace se;
using namespace se::view;

namespace {

constexpr std::uint32_t kEnd = std::numeric_limits<std::uint32_t>::max();

std::shared_ptr<const Model> runModel(const char* scene, const char* rules) {
    LoadProgress progress;
    return test::loadModel(withSet({scene}, rules), progress).value();
}

/// The final answer to a request.
RunnerAnswer answerOf(Runner& runner) {
    while (!runner.waitFor(std::chrono::seconds(10))) {
    }
    return *runner.take();
}

}  // namespace

TEST_CASE("The open run is made to its end once, whatever is requested meanwhile") {
    for (const char* rules : {"paper", "robust"}) {
        CAPTURE(rules);
        const auto model = runModel("scene:uneven-density", rules);
        Runner alone(model);
        alone.waitUntilMade();
        RunOverview straight;
        CHECK(alone.takeOverview(straight));
        Runner runner(model);
        RunOverview run;
        // Far ahead, back, and past the end, while it is made.
        for (const std::uint32_t pivot : {200U, 3U, 400U, 1U, kEnd, 40U}) {
            runner.request(pivot);
            const RunnerAnswer answer = answerOf(runner);
            CHECK(answer.complaint.empty());
            if (pivot != kEnd) CHECK(answer.record->pivot == pivot);
            runner.takeOverview(run);
        }
        runner.waitUntilMade();
        runner.takeOverview(run);
        CHECK(run.complete);
        CHECK(run.lastPivot == straight.lastPivot);
        CHECK(run.ringLength == straight.ringLength);
        CHECK(run.triangles == straight.triangles);
        CHECK(run.pivots.size() == straight.pivots.size());
        CHECK(run.marks.size() == straight.marks.size());
        CHECK(run.laneChanges.size() == straight.laneChanges.size());
        CHECK(run.failures.size() == straight.failures.size());
        REQUIRE(runner.end() != nullptr);
        CHECK(runner.end()->mesh == reconstruct(model->points, model->params).state.mesh());
        CHECK(runner.end()->mesh == alone.end()->mesh);
        CHECK(runner.end()->counts.eventsAt() == alone.end()->counts.eventsAt());
        CHECK_FALSE(runner.end()->capped);
        CHECK(runner.takeComplaint().empty());
    }
}

TEST_CASE("The next event about a point is found before the run is made, and after") {
    const auto model = runModel("scene:torus", "paper");
    Runner early(model);
    early.requestPoint(20, 1);
    const RunnerAnswer first = answerOf(early);
    REQUIRE(first.found);
    Runner late(model);
    late.waitUntilMade();
    late.requestPoint(20, 1);
    const RunnerAnswer second = answerOf(late);
    CHECK(second.found);
    CHECK(first.record->pivot == second.record->pivot);
    CHECK(first.record->pivot > 1);
    late.requestPoint(20, late.end() ? kEnd : 0);
    const RunnerAnswer none = answerOf(late);
    CHECK_FALSE(none.found);
}

TEST_CASE("A request can be ended on its way, and another one is served") {
    const auto model = runModel("scene:torus", "robust");
    Runner runner(model);
    runner.request(kEnd);
    runner.cancel();
    CHECK(answerOf(runner).record != nullptr);
    runner.request(5);
    CHECK(answerOf(runner).record->pivot == 5);
}
