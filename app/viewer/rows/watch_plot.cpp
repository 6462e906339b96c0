// Each column of pixels shows the least and the largest value of its pivots instead of a sample,
// so that a peak of a single pivot stays visible in a long run. O(pivots), computed again only
// when more of the run is known or the width changes.
#include "watch_plot.h"

#include <algorithm>

namespace se::view {

std::vector<PlotColumn> plotColumns(std::span<const double> values, std::size_t last,
                                    std::size_t columns) {
    std::vector<PlotColumn> plot;
    const std::size_t all = last + 1;
    for (std::size_t i = 0; i < columns; ++i) {
        const std::size_t from = i * all / columns;
        const std::size_t to = std::max(from + 1, (i + 1) * all / columns);
        if (from >= values.size()) break;
        const auto part = values.subspan(from, std::min(to, values.size()) - from);
        const auto [low, high] = std::minmax_element(part.begin(), part.end());
        plot.push_back({*low, *high});
    }
    return plot;
}

void keepPlot(PaintedPlot& plot, std::uint32_t generation, std::span<const double> values,
              std::size_t last, std::size_t columns) {
    const bool same = plot.generation == generation && plot.known == values.size() &&
                      plot.last == last && plot.columns.size() <= columns &&
                      plot.columns.size() + 1 >= columns;
    if (same) return;
    plot = {generation, values.size(), last, plotColumns(values, last, columns), 0.0, 0.0};
    if (values.empty()) return;
    const auto [low, high] = std::minmax_element(values.begin(), values.end());
    plot.low = *low;
    plot.high = *high;
}

}  // namespace se::view
