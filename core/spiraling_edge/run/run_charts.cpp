/// Histograms over one run, drawn as at most 16 bars of equal width from 1, 2, 5, 10 and so on.
/// Each bar has a query line that finds exactly its decisions.
#include "spiraling_edge/run/run_charts.h"

#include <array>
#include <map>
#include <memory>

#include "spiraling_edge/run/reading.h"
#include "spiraling_edge/run/sweep.h"

namespace se {
namespace {

constexpr std::uint32_t kMaxBars = 16;

/// The number of occurrences of each value.
using Histogram = std::map<std::uint32_t, std::uint64_t>;

/// The least width of 1, 2, 5, 10, 20 ... for which the bars of a chart cover `low` to `high`.
std::uint32_t widthFor(std::uint32_t low, std::uint32_t high) {
    std::uint64_t width = 1;
    for (std::size_t i = 0; high / width - low / width >= kMaxBars; ++i)
        width = i % 3 == 1 ? width / 2 * 5 : width * 2;
    return static_cast<std::uint32_t>(width);
}

/// Bars of equal width from the first to the last value.
std::vector<ChartBar> barsOf(const Histogram& histogram, const std::string& term) {
    std::vector<ChartBar> bars;
    if (histogram.empty()) return bars;
    const std::uint32_t width = widthFor(histogram.begin()->first, histogram.rbegin()->first);
    const std::uint32_t first = histogram.begin()->first / width;
    const std::uint32_t last = histogram.rbegin()->first / width;
    for (std::uint32_t i = first; i <= last; ++i) {
        const std::string from = std::to_string(i * width);
        const std::string to = std::to_string(i * width + width - 1);
        ChartBar bar{from, 0, "stage=pivot "};
        bar.query.append(term).append("=").append(from);
        if (width > 1) {
            bar.label.append("-").append(to);
            bar.query.append("..").append(to);
        }
        bars.push_back(bar);
    }
    for (const auto& [number, count] : histogram) bars[number / width - first].count += count;
    return bars;
}

/// Counts the decisions of a run.
class ChartCounter {
  public:
    void add(const SweptPivot& pivot) {
        bool looked = false;
        for (const Event& event : pivot.events) {
            if (isAgainst(outcomeOf(event)))
                ++refused_[static_cast<std::size_t>(event.address.stage)];
            looked = looked || event.address.stage == Stage::Pivot;
        }
        if (!looked) return;
        const PivotTally tally = tallyOf(pivot.events);
        ++ring_[tally.ringLength];
        ++candidates_[tally.candidates];
        ++tests_[tally.tests];
    }

    std::vector<RunChart> charts() const {
        std::vector<ChartBar> refusals;
        for (std::size_t i = 0; i < kStageCount; ++i) {
            const std::string name(stageName(static_cast<Stage>(i)));
            if (refused_[i] > 0)
                refusals.push_back({name, refused_[i], "stage=" + name + " refused"});
        }
        return {
            {"refusals", "Refusals by stage", "decisions", std::move(refusals)},
            {"ring", "Length of the ring", "pivots", barsOf(ring_, "ring")},
            {"candidates", "Candidates of a pivot", "pivots", barsOf(candidates_, "candidates")},
            {"tests", "Cost: tests of a pivot", "pivots", barsOf(tests_, "tests")}};
    }

  private:
    std::array<std::uint64_t, kStageCount> refused_{};
    Histogram ring_, candidates_, tests_;
};

}  // namespace

Question<std::vector<RunChart>> chartsQuestion() {
    const auto counter = std::make_shared<ChartCounter>();
    return {[counter](const SweptPivot& pivot) { counter->add(pivot); },
            [counter](const State&) -> Result<std::vector<RunChart>> { return counter->charts(); }};
}

Result<std::vector<RunChart>> runCharts(const PointSet& points, const Params& params,
                                        const Progress& progress) {
    return ask(points, params, chartsQuestion(), progress);
}

}  // namespace se
