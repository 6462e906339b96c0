#include <doctest/doctest.h>

#include <algorithm>

#include "commands/commands.h"
#include "document/actions.h"
#include "document/ask_actions.h"
#include "headless_app.h"

using namespace se;
using namespace se::view;

namespace {

/// Opens a scene and waits for all work.
struct Bench : test::HeadlessApp {
    explicit Bench(const char* source = "scene:figure-12") : HeadlessApp("breakpoints") {
        session.open(RunSpec{source});
        waitUntilDone();
    }
    void press(const char* key) { runCommand(*KeyMap().commandFor(*keyFromString(key)), context); }
    std::string place() {
        session.waitUntilDone();
        return session.event() == nullptr ? "start" : toString(session.address());
    }
    void set(const char* line) {
        ui.breakpoints.push_back({"", line});
        session.hits().want(ui.breakpoints);
    }
    /// All stops of `key`, until the end or the start.
    std::vector<std::string> stops(const char* key) {
        std::vector<std::string> places;
        for (;;) {
            press(key);
            const std::string at = place();
            if (session.atEnd() || session.atStart()) break;
            places.push_back(at);
        }
        return places;
    }
};

/// Plays until playing stops; returns the position.
std::string playOn(Bench& b, int count) {
    b.playback.play();
    for (int i = 0; i < 100000 && b.playback.playing() && !b.session.atEnd(); ++i) {
        if (!heldByBreakpoint(b.context, count)) playSteps(b.context, count);
        b.session.waitUntilDone();
    }
    return b.place();
}

}  // namespace

TEST_CASE("F5 and Shift+F5 stop at the same positions, for every preset") {
    Bench b;
    b.session.moves().goTo({30, Stage::Sphere, 1});
    b.session.waitUntilDone();
    b.session.select(Index{40});
    std::vector<std::string> lines;
    for (const BreakPreset& preset : breakPresets()) {
        if (const auto line = preset.line(breakSubject(b.context))) lines.push_back(*line);
    }
    std::size_t stopped = 0;
    for (const std::string& line : lines) {
        CAPTURE(line);
        REQUIRE(DecisionQuery::parse(line).ok());
        b.ui.breakpoints.clear();
        b.set(line.c_str());
        b.session.moves().toStart();
        std::vector<std::string> there = b.stops("F5");
        CHECK(b.session.atEnd());
        std::vector<std::string> back = b.stops("Shift+F5");
        std::reverse(back.begin(), back.end());
        CHECK(there == back);
        stopped += there.empty() ? 0 : 1;
    }
    CHECK(stopped > 8);
}

TEST_CASE("Without a breakpoint F5 runs to the end, and Shift+F5 to the start") {
    Bench b;
    b.press("F5");
    CHECK(b.place() == "123.finished.1");
    CHECK(b.session.atEnd());
    b.press("Shift+F5");
    CHECK(b.place() == "start");
}

TEST_CASE("F5 continues from the target of the previous move") {
    Bench b;
    b.set("stage=split");
    b.press("F5");
    const std::string first = b.place();
    for (int i = 0; i < 20; ++i) {
        b.press("End");
        b.press("Home");
        b.press("F5");
        CHECK(b.place() == first);
    }
}

TEST_CASE("F9 breaks on the selection, otherwise on this kind of decision, again removes it") {
    Bench b;
    b.press("F9");
    CHECK(b.ui.breakpoints.empty());
    b.session.moves().goTo({35, Stage::Split, 1});
    b.session.waitUntilDone();
    b.press("F9");
    REQUIRE(b.ui.breakpoints.size() == 1);
    CHECK(b.ui.breakpoints[0].line == "stage=split");
    b.session.select(Index{7});
    b.press("F9");
    REQUIRE(b.ui.breakpoints.size() == 2);
    CHECK(b.ui.breakpoints[1].line == "point=7");
    b.press("F9");
    b.session.select(Selection::ofTriangle({9, 8, 3}));
    b.press("F9");
    CHECK(b.ui.breakpoints.back().line == "among=3,8,9");
    b.session.select(Selection::ofEdge(4, 2));
    b.press("F9");
    CHECK(b.ui.breakpoints.back().line == "edge=2,4");
    b.press("F9");
    CHECK(b.ui.breakpoints.size() == 2);
}

TEST_CASE("Playing stops at the breakpoint that F5 goes to, in every unit") {
    Bench b;
    b.set("stage=sphere refused");
    b.press("F5");
    const std::string first = b.place();
    b.press("F5");
    const std::string second = b.place();
    CHECK(first != second);
    for (const PlayUnit unit : {PlayUnit::SubStep, PlayUnit::Pivot, PlayUnit::Event}) {
        for (const int count : {1, 8}) {
            b.playback.setUnit(unit);
            b.session.moves().toStart();
            CHECK(b.place() == "start");
            CHECK(playOn(b, count) == first);
            CHECK_FALSE(b.playback.playing());
            CHECK(playOn(b, count) == second);
        }
    }
}

TEST_CASE("Playing ignores breakpoints that are off or log-only") {
    Bench b;
    b.ui.breakpoints = {{"", "stage=sphere", 0, 1, false, false},
                        {"", "stage=sort", 0, 1, true, true}};
    b.session.hits().want(b.ui.breakpoints);
    b.playback.setUnit(PlayUnit::Pivot);
    playOn(b, 8);
    CHECK(b.session.atEnd());
    const LineHits* log = b.session.hits().of("stage=sort");
    REQUIRE(log != nullptr);
    CHECK(log->complete);
    CHECK(log->sentences.size() == std::min<std::size_t>(log->list.total, kMaxLogged));
    CHECK(b.session.hits().of("stage=sphere") == nullptr);
}

TEST_CASE("An empty line stops nothing") {
    Bench b;
    b.set("stage=dragon");
    b.set(" ");
    b.press("F5");
    b.session.waitUntilDone();
    CHECK(b.session.atEnd());
}

TEST_CASE("A search can be stopped, and resumes when it is needed") {
    Bench b;
    b.ui.breakpoints = {{"", "stage=split"}};
    b.session.hits().want(b.ui.breakpoints);
    b.session.hits().cancel();
    if (b.session.hits().cancelled()) CHECK(b.session.hits().of("stage=split") == nullptr);
    b.press("F5");
    CHECK(b.place().find(".split.1") != std::string::npos);
    CHECK(b.session.hits().of("stage=split")->complete);
}

TEST_CASE("Another input is searched from the start") {
    Bench b;
    b.set("stage=split");
    b.session.waitUntilDone();
    const std::uint64_t before = b.session.hits().of("stage=split")->list.total;
    b.session.open(RunSpec{"scene:sphere"});
    b.session.waitUntilDone();
    CHECK(before > 0);
    CHECK(b.session.hits().of("stage=split")->list.total != before);
}

TEST_CASE("Marks of hits: each pivot once, and at most as many as fit") {
    Bench b;
    b.set("stage=sort");
    b.session.waitUntilDone();
    const HitList& list = b.session.hits().of("stage=sort")->list;
    const Breakpoint& breakpoint = b.ui.breakpoints[0];
    const auto all = stopPivots(breakpoint, list, {0.0, 122.0}, 5000);
    std::vector<std::uint32_t> pivots;
    for (const Hit& hit : list.hits) {
        if (pivots.empty() || pivots.back() != hit.place.pivot) pivots.push_back(hit.place.pivot);
    }
    CHECK(all == pivots);
    const auto some = stopPivots(breakpoint, list, {20.0, 120.0}, 10);
    CHECK(some.size() <= 11);
    CHECK(some.size() >= 9);
    for (const std::uint32_t pivot : some) CHECK((pivot >= 20 && pivot <= 120));
}

TEST_CASE("Points are listed as short as they can be, and read back") {
    const std::vector<Index> points{1, 3, 4, 5, 9, 10, 40};
    CHECK(amongLine(points) == "among=1,3..5,9,10,40");
    CHECK(DecisionQuery::parse(amongLine(points)).ok());
}

TEST_CASE("A watched number is that of the state, at every pivot") {
    Bench b;
    b.ui.watch.expressions = {"ring", "triangles", "status=40", "dragons"};
    b.session.watches().want(b.ui.watch.expressions);
    b.session.waitUntilDone();
    CHECK(b.session.watches().of("dragons") == nullptr);
    const RunOverview& run = b.session.overview();
    for (std::uint32_t pivot = 1; pivot <= run.ringLength.size(); ++pivot) {
        REQUIRE(b.session.watches().of("ring")->values[pivot] == run.ringLength[pivot - 1]);
        REQUIRE(b.session.watches().of("triangles")->values[pivot] == run.triangles[pivot - 1]);
    }
    const WatchSeries* status = b.session.watches().of("status=40");
    REQUIRE(status->complete);
    CHECK(status->values.front() == 0.0);
    CHECK(status->values.back() == -1.0);
}

TEST_CASE("The scan for a watch can be stopped, and resumes on request") {
    Bench b;
    b.ui.watch.expressions = {"ring"};
    b.session.watches().want(b.ui.watch.expressions);
    WatchScan& scan = b.session.watches();
    REQUIRE(scan.busy());
    scan.cancel();
    // It may have ended before.
    const bool complete = scan.of("ring") != nullptr && scan.of("ring")->complete;
    CHECK(scan.cancelled() == !complete);
    CHECK_FALSE(scan.busy());
    b.waitUntilDone();
    CHECK(scan.cancelled() == !complete);
    scan.resume();
    b.waitUntilDone();
    CHECK_FALSE(scan.cancelled());
    CHECK(scan.of("ring")->complete);
    // Another expression is scanned at once, and so is the cancelled one.
    b.ui.watch.expressions = {"ring", "stack"};
    b.session.watches().want(b.ui.watch.expressions);
    scan.cancel();
    b.ui.watch.expressions = {"ring", "stack", "used"};
    b.session.watches().want(b.ui.watch.expressions);
    b.waitUntilDone();
    for (const std::string& each : b.ui.watch.expressions) CHECK(scan.of(each)->complete);
}

TEST_CASE("A plot keeps every peak, however many pivots share a column") {
    std::vector<double> values(10000, 5.0);
    values[4321] = 99.0;
    values[8765] = -7.0;
    const auto plot = plotColumns(values, 9999, 50);
    REQUIRE(plot.size() == 50);
    CHECK(plot[4321 / 200].high == 99.0);
    CHECK(plot[4321 / 200].low == 5.0);
    CHECK(plot[8765 / 200].low == -7.0);
    CHECK(std::count_if(plot.begin(), plot.end(),
                        [](const PlotColumn& c) { return c.low != 5.0 || c.high != 5.0; }) == 2);
    // Half of the run is known: half of the plot is drawn.
    CHECK(plotColumns(std::span(values).first(5000), 9999, 50).size() == 25);
    // Few pivots: each has several columns.
    const std::vector<double> few{1.0, 2.0};
    const auto wide = plotColumns(few, 1, 10);
    CHECK(wide[4].high == 1.0);
    CHECK(wide[5].low == 2.0);
}
