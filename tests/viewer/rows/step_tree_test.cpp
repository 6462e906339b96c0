#include "rows/step_tree.h"

#include <doctest/doctest.h>

#include "open_session.h"

using namespace se;
using namespace se::view;
using test::OpenSession;

namespace {

/// A run of `pivots` pivots, with seeds at the given ones.
RunOverview runOf(std::uint32_t pivots, const std::vector<std::uint32_t>& seeds) {
    RunOverview fresh;
    for (std::uint32_t pivot = 1; pivot <= pivots; ++pivot) {
        PivotSummary summary{findingOf(Stage::Pivot), pivot + 1000, 4, 0};
        for (const std::uint32_t seed : seeds) {
            if (seed == pivot) summary.found |= findingOf(Stage::Seed);
        }
        if (pivot % 10 == 0) {
            summary.found |= findingOf(Stage::Sphere) | findingOf(Verdict::Removed);
            summary.refused = 1;
        }
        fresh.pivots.push_back(summary);
    }
    fresh.lastPivot = pivots;
    fresh.complete = true;
    RunOverview run;
    append(run, fresh);
    return run;
}

/// Pivot number `pivot` with one pivot event and three tests, one of them refused.
PivotRecord recordOf(std::uint32_t pivot) {
    PivotRecord record;
    record.pivot = pivot;
    record.events.push_back({{pivot, Stage::Pivot, 1}, PivotEvidence{5, 6, 7, 12, 90.0}});
    for (std::uint32_t n = 1; n <= 3; ++n) {
        const Verdict verdict = n == 2 ? Verdict::Removed : Verdict::InsideSphere;
        record.events.push_back({{pivot, Stage::Sphere, n},
                                 SphereEvidence{1, 800 + n, 3, {}, 1.0, 2.0, 60.0, verdict}});
    }
    return record;
}

/// Every row leads to a different target, and the row of the cursor to the cursor.
void checkRows(const StepTree& tree) {
    for (std::size_t i = 1; i < tree.rowCount(); ++i) CHECK_FALSE(tree.row(i) == tree.row(i - 1));
}

}  // namespace

TEST_CASE("The tree shows the component and the pivot of the cursor opened") {
    const RunOverview run = runOf(100, {1, 41});
    REQUIRE(run.components.size() == 2);
    CHECK(run.components[0].tests == 160);
    CHECK(run.components[1].refused == 6);
    const PivotRecord record = recordOf(50);
    StepTree tree;
    tree.update(run, 1, record, 2);
    // Two components, 60 pivots of the second, a pivot's two stages, three tests of the second.
    CHECK(tree.rowCount() == 2 + 60 + 2 + 3);
    checkRows(tree);
    CHECK(tree.row(0).kind == StepRowKind::Component);
    CHECK(tree.row(1).component == 1);
    CHECK(tree.row(2) == StepRow{StepRowKind::Pivot, 1, 41, 0, 0});
    const auto cursor = tree.rowOfCursor();
    REQUIRE(cursor);
    CHECK(tree.row(*cursor) == StepRow{StepRowKind::Test, 1, 50, 1, 2});
    CHECK(tree.row(tree.rowCount() - 1).pivot == 100);
    CHECK_FALSE(tree.canOpen(tree.row(*cursor)));
    CHECK_FALSE(tree.canOpen({StepRowKind::Stage, 1, 50, 0, 0}));
}

TEST_CASE("Rows can be folded and opened, the cursor's row is then the enclosing one") {
    const RunOverview run = runOf(100, {1, 41});
    const PivotRecord record = recordOf(50);
    StepTree tree;
    tree.update(run, 1, record, 2);
    tree.toggle({StepRowKind::Stage, 1, 50, 1, 1});
    CHECK(tree.rowCount() == 2 + 60 + 2);
    CHECK(tree.row(*tree.rowOfCursor()).kind == StepRowKind::Stage);
    tree.toggle({StepRowKind::Pivot, 1, 50, 0, 0});
    CHECK(tree.rowCount() == 2 + 60);
    CHECK(tree.row(*tree.rowOfCursor()) == StepRow{StepRowKind::Pivot, 1, 50, 0, 0});
    tree.toggle({StepRowKind::Component, 1, 0, 0, 0});
    CHECK(tree.rowCount() == 2);
    CHECK(tree.row(*tree.rowOfCursor()).component == 1);
    tree.toggle({StepRowKind::Component, 0, 0, 0, 0});
    CHECK(tree.rowCount() == 2 + 40);
    CHECK(tree.row(*tree.rowOfCursor()) == StepRow{StepRowKind::Component, 1, 0, 0, 0});
    checkRows(tree);
}

TEST_CASE("A stage opened by hand stays open at other pivots") {
    const RunOverview run = runOf(100, {1});
    const PivotRecord here = recordOf(50);
    StepTree tree;
    tree.update(run, 1, here, 0);
    CHECK_FALSE(tree.isOpen({StepRowKind::Stage, 0, 50, 1, 1}));
    tree.toggle({StepRowKind::Stage, 0, 50, 1, 1});
    const PivotRecord there = recordOf(51);
    tree.update(run, 1, there, 0);
    CHECK(tree.isOpen({StepRowKind::Stage, 0, 51, 1, 1}));
    CHECK(tree.row(*tree.rowOfCursor()) == StepRow{StepRowKind::Stage, 0, 51, 0, 0});
}

TEST_CASE("The filter leaves pivots by their summary and tests by their text") {
    const RunOverview run = runOf(100, {1});
    const PivotRecord record = recordOf(50);
    StepTree tree;
    tree.update(run, 1, record, 2);
    tree.setFilter("x");
    // Ten pivots, and the refused test of the current one.
    CHECK(tree.rowCount() == 11);
    CHECK(tree.row(4).pivot == 50);
    CHECK(tree.row(5) == StepRow{StepRowKind::Test, 0, 50, 1, 2});
    CHECK(tree.row(6).pivot == 60);
    CHECK(tree.rowOfCursor() == 5);
    tree.setFilter("Sphere removed");
    CHECK(tree.rowCount() == 11);
    tree.setFilter("1077");
    CHECK(tree.rowCount() == 1);
    CHECK(tree.row(0).pivot == 77);
    tree.setFilter("802");
    // No pivot by its summary, but a test of the current one.
    CHECK(tree.rowCount() == 2);
    CHECK(tree.row(0).pivot == 50);
    CHECK(tree.row(1).event == 2);
    tree.setFilter("nonsense");
    CHECK(tree.rowCount() == 0);
    CHECK_FALSE(tree.rowOfCursor());
    tree.setFilter("");
    CHECK(tree.rowCount() == 1 + 100 + 2 + 3);
}

TEST_CASE("New pivots during the run are filtered as well") {
    RunOverview run = runOf(100, {1});
    const PivotRecord record = recordOf(5);
    StepTree tree;
    tree.update(run, 1, record, 0);
    tree.setFilter("removed");
    const std::size_t before = tree.rowCount();
    append(run, runOf(100, {}));
    tree.update(run, 1, record, 0);
    CHECK(tree.rowCount() == before + 10);
    CHECK(run.components.size() == 1);
}

TEST_CASE("A million pivots are ordinary rows") {
    const RunOverview run = runOf(1'000'000, {1, 500'000});
    const PivotRecord record = recordOf(700'000);
    StepTree tree;
    tree.update(run, 1, record, 2);
    CHECK(tree.rowCount() == 2 + 500'001 + 2 + 3);
    const auto cursor = tree.rowOfCursor();
    REQUIRE(cursor);
    CHECK(tree.row(*cursor).event == 2);
    CHECK(tree.row(tree.rowCount() - 1).pivot == 1'000'000);
}

TEST_CASE("In a session every event has a row") {
    OpenSession open("scene:torus");
    open.session.moves().goToPivot(137);
    open.session.waitUntilDone();
    StepTree tree;
    for (std::size_t cursor = 0; cursor < open.session.record().events.size(); ++cursor) {
        open.session.moves().goToEvent(cursor);
        tree.update(open.session.overview(), open.session.generation(), open.session.record(),
                    open.session.cursor());
        const auto row = tree.rowOfCursor();
        REQUIRE(row);
        CHECK(tree.row(*row).event == cursor);
    }
    // The counts of the overview equal those of the pivot's own events.
    const PivotSummary& summary = open.session.overview().pivots[136];
    std::size_t tests = 0;
    for (const StageRun& run : tree.runs()) tests += run.tests;
    CHECK(summary.tests == tests);
    CHECK(summary.point == open.session.picture().pivot);
}
