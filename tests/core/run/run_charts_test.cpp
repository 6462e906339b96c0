#include "spiraling_edge/run/run_charts.h"

#include <doctest/doctest.h>

#include <set>

#include "spiraling_edge/run/decision_query.h"
#include "spiraling_edge/run/sweep.h"
#include "spiraling_edge/scenes/scenes.h"
#include "support/clouds.h"
#include "support/rig.h"

using namespace se;
using namespace se::test;

namespace {

std::size_t foundBy(const PointSet& points, const Params& params, const std::string& line) {
    const auto query = DecisionQuery::parse(line);
    REQUIRE(query.ok());
    return findDecisions(points, params, query.value(), 1).value().total;
}

}  // namespace

TEST_CASE("charts: the query line of every bar finds exactly as many decisions as it counts") {
    for (const char* id : {"torus", "grid", "stranded-point"}) {
        for (const char* rules : {"paper", "robust"}) {
            const PointSet points = prepared(findScene(id)->build());
            const Params params = *paramsByName(rules);
            const std::vector<RunChart> charts = runCharts(points, params).value();
            REQUIRE(charts.size() == 4);
            for (const RunChart& chart : charts) {
                CHECK(chart.bars.size() >= 1);
                CHECK(chart.bars.size() <= (chart.name == "refusals" ? kStageCount : 16));
                for (const ChartBar& bar : chart.bars) {
                    CAPTURE(id);
                    CAPTURE(bar.query);
                    CHECK(foundBy(points, params, bar.query) == bar.count);
                }
            }
        }
    }
}

TEST_CASE(
    "charts: the bars of a chart of pivots hold every pivot once, those of stages every refusal") {
    const PointSet points = prepared(findScene("torus")->build());
    const std::vector<RunChart> charts = runCharts(points, paper()).value();
    const std::size_t pivots = foundBy(points, paper(), "stage=pivot");
    for (const RunChart& chart : charts) {
        std::uint64_t sum = 0;
        std::set<std::string> labels;
        for (const ChartBar& bar : chart.bars) {
            sum += bar.count;
            CHECK(labels.insert(bar.label).second);
        }
        CAPTURE(std::string(chart.name));
        CHECK(sum == (chart.name == "refusals" ? foundBy(points, paper(), "refused") : pivots));
    }
}

TEST_CASE("charts: a pivot's numbers are those of its own events") {
    const PointSet points = prepared(closedFamilies()[1].sample(1));
    sweep(points, paper(), [](const SweptPivot& pivot) {
        const PivotTally tally = tallyOf(pivot.events);
        std::uint32_t kept = 0;
        for (const Event& event : pivot.events) {
            if (const auto* e = std::get_if<PivotEvidence>(&event.evidence))
                CHECK(tally.ringLength == e->ringLength);
            const auto* sort = std::get_if<SortEvidence>(&event.evidence);
            if (sort != nullptr && sort->verdict == Verdict::Kept) ++kept;
        }
        CHECK(tally.candidates == kept);
        CHECK(tally.tests >= tally.candidates);
        CHECK(tally.tests <= pivot.events.size());
    });
}

TEST_CASE("charts: cancelled") {
    const PointSet points = prepared(findScene("torus")->build());
    CHECK_FALSE(runCharts(points, paper(), [](double) { return false; }).ok());
}
