#include "compare/comparison.h"

#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <thread>

#include "../../teach/trace/traced_scenes.h"
#include "open_session.h"

using namespace se;
using namespace se::view;

namespace {

/// A run, and the trace of another one in a file.
struct TracedPair {
    test::OpenSession open;
    Session& run = open.session;
    Comparison comparison;
    std::filesystem::path file = test::ownPlace("mine.setrace");

    explicit TracedPair(const char* source) : open(source) {}
    ~TracedPair() { std::filesystem::remove(file); }
    std::string text(const char* rule = "") {
        const SharedPoints points(run.model().points);
        const Params& params = run.model().params;
        return teach::traceText(points, *rule == 0 ? params : teach::withRule(params, rule));
    }
    void write(const std::string& text) {
        static int seconds = 0;
        std::ofstream(file) << text;
        // Two writes may come within the resolution of the time.
        std::filesystem::last_write_time(
            file, std::filesystem::file_time_type::clock::now() + std::chrono::seconds(++seconds));
    }
    void compare() {
        comparison.start(run, CompareWith::otherTrace(file.string()));
        comparison.waitUntilDone(run);
    }
    void goTo(const char* place) {
        REQUIRE(run.moves().goToText(place).ok());
        run.waitUntilDone();
        comparison.waitUntilDone(run);
    }
    const TraceReplay& replay() { return comparison.result()->trace->replay; }
    DecisionState state() { return replay().stateAt(comparison.tracePosition(run)); }
};

std::vector<Index> activeRing(const DecisionState& state) {
    for (const RingPath& each : state.rings) {
        if (each.active) return each.points;
    }
    return {};
}

}  // namespace

TEST_CASE("The trace of the same run makes its mesh, triangle by triangle, and its rings") {
    TracedPair pair("scene:figure-8");
    pair.write(pair.text());
    pair.compare();
    REQUIRE(pair.comparison.result() != nullptr);
    CHECK_FALSE(pair.comparison.result()->trace->comparison.difference);
    CHECK(pair.comparison.result()->meshes.same());
    CHECK(pair.replay().mesh().triangles == pair.comparison.result()->runs.a.inOrder());
    for (const char* place : {"1", "2", "8", "20", "40"}) {
        CAPTURE(place);
        pair.goTo(place);
        const DecisionState ours = pair.run.picture();
        const DecisionState state = pair.state();
        CHECK(state.complete);
        CHECK(state.pivot == ours.pivot);
        CHECK(state.nextPivot == ours.nextPivot);
        CHECK(state.finishedTriangles == ours.finishedTriangles + ours.newTriangles.size());
        // Later the ring goes along walls, which a trace does not tell.
        if (pair.run.record().pivot > 8) continue;
        CHECK(activeRing(state) == activeRing(ours));
        CHECK(state.status.counts() == ours.status.counts());
    }
}

TEST_CASE("The fan of a trace is laid as the run emits its own") {
    TracedPair pair("scene:figure-8");
    pair.write(pair.text());
    pair.compare();
    pair.goTo("9.sphere.2");
    CHECK(pair.state().newTriangles.empty());
    CHECK(pair.replay().fanOf(9).size() == 4);
    CHECK(pair.state().candidates.size() == 3);
    pair.goTo("9.emit.3");
    CHECK(pair.state().newTriangles.size() == 3);
    CHECK(pair.state().newTriangles == pair.run.picture().newTriangles);
    pair.goTo("9.ring.1");
    CHECK(pair.state().newTriangles.size() == 4);
    CHECK(pair.replay().sentence(pair.comparison.tracePosition(pair.run)) ==
          "Pivot 9 of the trace: point 15 between 20 and 39, fan 20 9 31 35 39.");
    pair.goTo("0");
    CHECK(pair.state().finishedTriangles == 0);
    CHECK(pair.state().pivot == kNone);
}

TEST_CASE("A run that begins with triangles is compared with a trace that begins with them too") {
    TracedPair pair("scene:figure-3");
    REQUIRE_FALSE(pair.run.model().params.start.empty());
    pair.write(pair.text());
    pair.compare();
    CHECK(pair.comparison.result()->meshes.same());
}

TEST_CASE("A trace by another rule differs first where diff says, and that rule is named") {
    TracedPair pair("scene:figure-8");
    pair.write(pair.text("limits=off"));
    pair.compare();
    const ComparedTrace& traced = *pair.comparison.result()->trace;
    REQUIRE(traced.comparison.difference);
    CHECK(traced.comparison.difference->what == "the fans differ");
    CHECK(traced.guess.find("like --rule limits=off") != std::string::npos);
    CHECK(pair.comparison.result()->meshes.onlyB > 0);
    // Both are at their ends at last.
    pair.goTo("100%");
    CHECK(pair.comparison.tracePosition(pair.run) ==
          TracePosition{pair.replay().pivots(), 0, true});
}

TEST_CASE("A trace that ends early is that of the run as far as it goes") {
    TracedPair pair("scene:figure-8");
    const std::string whole = pair.text();
    std::size_t end = 0;
    for (int line = 0; line < 21; ++line) end = whole.find('\n', end) + 1;
    pair.write(whole.substr(0, end));
    pair.compare();
    const auto& difference = pair.comparison.result()->trace->comparison.difference;
    REQUIRE(difference);
    CHECK(difference->pivot == 21);
    CHECK(difference->runPivots == 76);
    CHECK(pair.comparison.result()->trace->guess.empty());
    CHECK(pair.comparison.result()->meshes.onlyA > 0);
    pair.goTo("40.emit.1");
    CHECK(pair.comparison.tracePosition(pair.run) == TracePosition{20, 0, true});
}

TEST_CASE("A trace is read again when its file changes, a faulty one is refused") {
    TracedPair pair("scene:figure-8");
    const std::string good = pair.text();
    pair.write(pair.text("sphere=off"));
    pair.compare();
    REQUIRE(pair.comparison.result()->trace->comparison.difference);
    const auto changes = [&](const std::string& text) {
        pair.write(text);
        const Compared* before = pair.comparison.result();
        for (int i = 0;
             i < 200 && pair.comparison.result() == before && pair.comparison.refusal().empty();
             ++i) {
            std::this_thread::sleep_for(std::chrono::milliseconds(20));
            pair.comparison.waitUntilDone(pair.run);
        }
    };
    changes(good.substr(0, good.size() / 2));
    CHECK(pair.comparison.refusal().find(pair.file.string() + ":") == 0);
    REQUIRE(pair.comparison.result() != nullptr);
    CHECK(pair.comparison.result()->trace->comparison.difference);
    changes("");
    CHECK_FALSE(pair.comparison.refusal().empty());
    pair.goTo("8.limits.3");
    pair.write(good);
    for (int i = 0; i < 500 && !pair.comparison.refusal().empty(); ++i) {
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
        pair.comparison.waitUntilDone(pair.run);
    }
    CHECK(pair.comparison.refusal().empty());
    CHECK_FALSE(pair.comparison.result()->trace->comparison.difference);
    CHECK(toString(pair.run.address()) == "8.limits.3");
}

TEST_CASE("A trace of other points is refused, and the comparison before stays") {
    TracedPair pair("scene:figure-8");
    pair.write(pair.text());
    pair.compare();
    const std::filesystem::path other = test::ownPlace("other.setrace");
    std::ofstream(other) << "{\"setrace\": 1, \"points\": 3}\n";
    pair.comparison.start(pair.run, CompareWith::otherTrace(other.string()));
    pair.comparison.waitUntilDone(pair.run);
    CHECK(pair.comparison.refusal().find("points: ") != std::string::npos);
    CHECK(pair.comparison.with().path == pair.file.string());
    CHECK(pair.comparison.complaint().empty());
    // Without one before, it is the reason why there is nothing to show.
    pair.comparison.cancel();
    pair.comparison.start(pair.run, CompareWith::otherTrace(other.string()));
    pair.comparison.waitUntilDone(pair.run);
    CHECK(pair.comparison.complaint().find("points: ") != std::string::npos);
    std::filesystem::remove(other);
}

TEST_CASE("With other rules of the run the trace is compared again") {
    TracedPair pair("scene:figure-8");
    pair.write(pair.text("sphere=off"));
    pair.compare();
    REQUIRE(pair.comparison.result()->trace->comparison.difference);
    pair.run.rerun(withRule(pair.run.input().spec(), "sphere", 0.0));
    pair.run.waitUntilDone();
    pair.comparison.waitUntilDone(pair.run);
    REQUIRE(pair.comparison.result() != nullptr);
    CHECK_FALSE(pair.comparison.result()->trace->comparison.difference);
}
