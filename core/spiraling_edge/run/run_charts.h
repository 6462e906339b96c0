/// A whole run in a few charts. Each bar is a list of decisions: its query line finds exactly as
/// many as the bar counts.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "spiraling_edge/run/sweep.h"

namespace se {

struct ChartBar {
    std::string label;        ///< "sphere", "12", "10-19".
    std::uint64_t count = 0;  ///< Decisions.
    std::string query;        ///< A line for decision_query.h: "stage=sphere refused".
};

struct RunChart {
    std::string_view name;   ///< One word: "refusals", "ring", "candidates", "tests".
    std::string_view title;  ///< For display.
    std::string_view unit;   ///< Unit of the counts: "decisions", "pivots".
    std::vector<ChartBar> bars;
};

/// The question for the charts: refusals by stage; over the pivots with a ring entry, the length of
/// the ring, the candidates of §6.1, the tests. At most 16 bars a chart, of equal width. O(run).
/// Deterministic.
Question<std::vector<RunChart>> chartsQuestion();
/// The answer to chartsQuestion(). Fails if cancelled.
Result<std::vector<RunChart>> runCharts(const PointSet& points, const Params& params,
                                        const Progress& progress = {});

}  // namespace se
