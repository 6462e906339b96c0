/// A watched number over the whole run, as columns of a small plot. Plain values.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace se::view {

/// The number within one column of pixels.
struct PlotColumn {
    double low = 0.0;
    double high = 0.0;
};

/// The least and the largest value in each of `columns` stretches of [0, last], `values` being the
/// known ones by pivot: no peak is lost, however many pivots share a column. Columns without
/// known values are left out at the end.
std::vector<PlotColumn> plotColumns(std::span<const double> values, std::size_t last,
                                    std::size_t columns);

/// The columns as last computed, and their inputs.
struct PaintedPlot {
    std::uint32_t generation = 0;
    std::size_t known = 0;
    std::size_t last = 0;
    std::vector<PlotColumn> columns;
    double low = 0.0;
    double high = 0.0;
};

/// Computes the plot again if something has changed.
void keepPlot(PaintedPlot& plot, std::uint32_t generation, std::span<const double> values,
              std::size_t last, std::size_t columns);

}  // namespace se::view
