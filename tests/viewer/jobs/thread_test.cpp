#include "jobs/thread.h"

#include <doctest/doctest.h>

#include <atomic>
#include <memory>
#include <new>
#include <stdexcept>
#include <thread>

#include "compare/comparison.h"
#include "jobs/background_job.h"
#include "jobs/doctor_job.h"
#include "jobs/growth.h"
#include "jobs/kept_pass.h"
#include "jobs/runner.h"
#include "open_session.h"
#include "session/session_input.h"
#include "spiraling_edge/run/run_charts.h"
#include "support/scarce_memory.h"

using namespace se;
using namespace se::view;

namespace {

bool saysOutOfMemory(const std::string& sentence) { return sentence.starts_with("Out of memory."); }

}  // namespace

TEST_CASE("An exception becomes a sentence") {
    CHECK(guarded([] {}).ok());
    const auto of = [](const std::function<void()>& work) { return guarded(work).error().message; };
    CHECK(saysOutOfMemory(of([] { throw std::bad_alloc(); })));
    CHECK(saysOutOfMemory(of([] { throw std::length_error("vector::reserve"); })));
    CHECK(of([] { throw std::runtime_error("it broke"); }) == "Internal error: it broke.");
    CHECK(of([] { throw 7; }).starts_with("Internal error"));
}

TEST_CASE("Without memory an input is not opened, and the program continues" *
          doctest::test_suite("threads")) {
    Session session;
    {
        const ScarceMemory scarce(4096);
        session.open(RunSpec{"scene:torus"});
        session.waitUntilDone();
        CHECK(session.input().phase() == SessionPhase::Failed);
        CHECK(saysOutOfMemory(session.input().error()));
    }
    session.open(RunSpec{"scene:torus"});
    session.waitUntilDone();
    CHECK(session.ready());
}

TEST_CASE("Without memory a move ends where it began, with a reason" *
          doctest::test_suite("threads")) {
    test::OpenSession open("scene:torus");
    REQUIRE(open.session.ready());
    {
        const ScarceMemory scarce(512);
        open.session.moves().toEnd();
        while (open.session.moves().busy()) open.session.poll();
    }
    CHECK(saysOutOfMemory(open.session.messages().last()));
    CHECK(open.session.record().pivot == 0);
    open.session.moves().toEnd();
    open.session.waitUntilDone();
    CHECK(saysOutOfMemory(open.session.messages().last()));
    open.session.open(RunSpec{"scene:sphere"});
    open.session.waitUntilDone();
    open.session.moves().toEnd();
    open.session.waitUntilDone();
    CHECK(open.session.atEnd());
}

TEST_CASE("Without memory a run is not made to its end, with a reason" *
          doctest::test_suite("threads")) {
    const auto model = test::sphereModel();
    const ScarceMemory scarce;
    Runner run(model);
    run.waitUntilMade();
    CHECK(run.end() == nullptr);
    CHECK(saysOutOfMemory(run.takeComplaint()));
    CHECK(run.takeComplaint().empty());
}

TEST_CASE("Without memory the doctor gives the reason for no result" *
          doctest::test_suite("threads")) {
    LoadProgress progress;
    const auto loaded = loadInput(RunSpec{"scene:torus"}, progress);
    REQUIRE(loaded.ok());
    DoctorJob doctorJob;
    doctorJob.enqueue(loaded.value().file);
    {
        const ScarceMemory scarce;
        doctorJob.start();
        doctorJob.waitUntilDone();
    }
    CHECK(doctorJob.poll());
    CHECK_FALSE(doctorJob.done());
    CHECK_FALSE(doctorJob.busy());
    CHECK(saysOutOfMemory(doctorJob.complaint()));
}

TEST_CASE("Without memory a comparison gives the reason for no result" *
          doctest::test_suite("threads")) {
    test::OpenSession open("scene:torus");
    Comparison comparison;
    {
        const ScarceMemory scarce(512);
        comparison.start(open.session, CompareWith::otherMesh("/dev/null"));
        comparison.waitUntilDone(open.session);
    }
    CHECK_FALSE(comparison.working());
    CHECK(saysOutOfMemory(comparison.complaint()));
}

TEST_CASE("An exception in a query is its complaint") {
    BackgroundQuery<int> query;
    query.start([](const Progress&) -> Result<int> { throw std::runtime_error("it broke"); });
    query.waitUntilDone();
    CHECK(query.poll());
    CHECK(query.answer() == nullptr);
    CHECK(query.complaint() == "Internal error: it broke.");
    query.start([](const Progress&) -> Result<int> { return 5; });
    query.waitUntilDone();
    CHECK(query.poll());
    REQUIRE(query.answer() != nullptr);
    CHECK(query.complaint().empty());
}

TEST_CASE("Without memory breakpoints and watches are cancelled, with a reason" *
          doctest::test_suite("threads")) {
    const auto model = test::sphereModel();
    HitSearch hits;
    WatchScan watches;
    {
        const ScarceMemory scarce;
        hits.open(model);
        hits.want(std::vector<Breakpoint>{{"", "stage=sphere", 0, 1, true, false}});
        hits.waitUntilDone();
        watches.open(model);
        watches.want(std::vector<std::string>{"ring"});
        watches.waitUntilDone();
    }
    CHECK(hits.cancelled());
    CHECK(saysOutOfMemory(hits.takeComplaint()));
    CHECK(watches.cancelled());
    CHECK(saysOutOfMemory(watches.takeComplaint()));
    watches.resume();
    watches.waitUntilDone();
    CHECK(watches.of("ring")->complete);
}

TEST_CASE("Without memory new points fail, with a reason" * doctest::test_suite("threads")) {
    Growth growth;
    {
        const ScarceMemory scarce;
        growth.start(sampleFromSource("sample:torus,n=400").value());
        growth.waitUntilDone();
    }
    CHECK(growth.phase() == GrowthPhase::Failed);
    CHECK(saysOutOfMemory(growth.error()));
}

TEST_CASE("Works in slices take turns, and a paused one rests") {
    using std::chrono::milliseconds;
    const auto counting = [](std::atomic<int>& count, Slice next) {
        return [&count, next](const CancelFlag& cancelled) {
            if (cancelled.isSet()) return Slice::Done;
            ++count;
            std::this_thread::sleep_for(milliseconds(2));
            return next;
        };
    };
    std::atomic<int> first = 0;
    std::atomic<int> second = 0;
    std::atomic<int> idle = 0;
    Thread a(counting(first, Slice::More));
    Thread b(counting(second, Slice::More));
    Thread c(counting(idle, Slice::Idle));
    while (first < 5 || second < 5 || idle < 1) runSlices(milliseconds(1));
    for (int i = 0; i < 20; ++i) runSlices(milliseconds(1));
    CHECK(idle == 1);
    c.wake();
    while (idle < 2) runSlices(milliseconds(1));
    CHECK(idle == 2);
    for (Thread* each : {&a, &b, &c}) each->cancel();
    for (Thread* each : {&a, &b, &c}) each->waitUntilDone();
}

TEST_CASE("A question that was cancelled keeps nothing of its run") {
    auto model = test::sphereModel();
    const std::weak_ptr<const Model> watched = model;
    BackgroundQuery<std::vector<RunChart>> query;
    query.ask(model, [](const Model&) { return chartsQuestion(); });
    query.cancel();
    model.reset();
    for (int i = 0; i < 1000 && !watched.expired(); ++i)
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    CHECK(watched.expired());
    model = test::sphereModel();
    query.ask(model, [](const Model&) { return chartsQuestion(); });
    query.waitUntilDone();
    CHECK(query.poll());
    REQUIRE(query.answer() != nullptr);
    CHECK(query.answer()->size() == 4);
}
